// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "child_process.hpp"

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace benchmark {

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::vector<std::string>& environment)
    : name_(command.front())
{
    // A helper that died is told by its missing answer, not by a signal.
    std::signal(SIGPIPE, SIG_IGN);
    int questions[2], answers[2];
    // Helpers must not inherit each other's pipes, or closing one would not end it.
    if (pipe2(questions, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0)
        throw std::runtime_error("cannot make a pipe");
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    child_ = fork();
    if (child_ < 0)
        throw std::runtime_error("cannot start " + name_);
    if (child_ == 0)
    {
        dup2(questions[0], STDIN_FILENO);
        dup2(answers[1], STDOUT_FILENO);
        for (const std::string& variable : environment)
            putenv(const_cast<char*>(variable.c_str()));
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    close(questions[0]);
    close(answers[1]);
    to_ = fdopen(questions[1], "w");
    from_ = fdopen(answers[0], "r");
}

ChildProcess::~ChildProcess()
{
    std::fclose(to_);
    std::fclose(from_);
    waitpid(child_, nullptr, 0);
}

std::string ChildProcess::ask(const std::string& question)
{
    char answer[512];
    const bool asked = std::fprintf(to_, "%s\n", question.c_str()) > 0 && std::fflush(to_) == 0;
    if (!asked || !std::fgets(answer, sizeof(answer), from_))
        throw std::runtime_error(name_ + " does not answer: " + question);
    std::string text = answer;
    text.erase(text.find_last_not_of("\n") + 1);
    return text;
}

} // namespace benchmark

#!/usr/bin/env python3
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Reads the library's machine code: is the dispatched code there, called, and vectorised?

    check_vectors.py LIBRARY [--sets SET...] [--hot NAME...] [--hot-above NAME...]
                     [--objdump PROGRAM]

Checks that
- every function that a .simd.hpp declares is there for each set of --sets, and is called from outside
  of the set's own code, that is by a dispatcher (which the baseline's code may be a part of);
- no other code has instructions of these sets: a machine without them would stop there;
- the --hot functions, with what they call, compute in vectors of the set's width; those of
  --hot-above do in all sets but the baseline.
Prints a table of how many instructions of which width each function's arithmetic has; moves do not
count. The library must have its symbols.
"""

import argparse
import collections
import re
import subprocess
import sys

BASELINE = 'cpu_baseline'
# Bits of the arithmetic that a hot function must have. Compilers may prefer 256 bits where 512
# would slow down the clock.
HOT_WIDTH = {BASELINE: 128, 'AVX2': 256, 'AVX512_SKX': 256}

HEAD = re.compile(r'^[0-9a-f]+ <(.*)>:$')
TARGET = re.compile(r'<([^+]*(?:operator\+[^+]*)?)>$')
DISPATCHED = re.compile(r'^(?:.* )?cv::linespace::(?:opt_(\w+?)|(cpu_baseline))::(.*)$')
X86_ARITHMETIC = re.compile(r'^v?p(?:add|sub|and|or|min|max|cmp|shuf|blend|mul|mad|srl|sll)')
X86_REGISTER = re.compile(r'%([xyz])mm')
X86_WIDTH = {'x': 128, 'y': 256, 'z': 512}
ARM_ARITHMETIC = re.compile(r'\bv\d+\.(?:16b|8h|4s|2d)')
ARM_MOVES = re.compile(r'^(?:ld|st|mov|dup|ins|zip|uzp|trn|ext|xtn)')


class Function:
    def __init__(self, name):
        self.name = name
        match = DISPATCHED.match(qualified(name))
        self.set = (match.group(1) or match.group(2)) if match else None
        rest = match.group(3) if match else ''
        self.is_local = rest.startswith('(anonymous namespace)')
        self.short_name = re.sub(r'[<(].*', '', rest)
        self.calls = set()
        self.widths = collections.Counter()
        self.avx = None


def qualified(name):
    """The name up to its parameters, whose types may come from any namespace."""
    return name.replace('(anonymous namespace)', '\0').split('(')[0].replace(
        '\0', '(anonymous namespace)')


def read(library, objdump):
    command = [objdump, '--disassemble', '--demangle', '--no-show-raw-insn', library]
    functions, current = {}, None
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    for line in text.splitlines():
        head = HEAD.match(line)
        if head:
            # Of several symbols of a name (clones in one file each) the code is joined.
            current = functions.setdefault(head.group(1), Function(head.group(1)))
            continue
        fields = line.split('\t')
        if current is None or len(fields) < 2:
            continue
        note(current, fields[1].strip() if len(fields) == 2 else '\t'.join(fields[1:]))
    return functions


def note(function, instruction):
    mnemonic, _, operands = instruction.replace('\t', ' ').partition(' ')
    target = TARGET.search(operands)
    if target and target.group(1) != function.name:
        function.calls.add(target.group(1).removesuffix('@plt'))
    registers = X86_REGISTER.findall(operands)
    if registers:
        if mnemonic.startswith('v') or 'z' in registers or 'y' in registers:
            function.avx = function.avx or instruction
        if X86_ARITHMETIC.match(mnemonic):
            function.widths[max(X86_WIDTH[r] for r in registers)] += 1
    elif ARM_ARITHMETIC.search(operands) and not ARM_MOVES.match(mnemonic):
        function.widths[128] += 1


def widths_of(function, functions):
    """Vector arithmetic of a function and of all that it calls of its own set."""
    seen, waiting, widths = set(), [function], collections.Counter()
    while waiting:
        caller = waiting.pop()
        if caller.name in seen:
            continue
        seen.add(caller.name)
        widths.update(caller.widths)
        waiting += [functions[name] for name in caller.calls
                    if name in functions and functions[name].set == function.set]
    return widths


def check(functions, sets, hot, hot_above):
    problems = []
    entries = collections.defaultdict(dict)
    for function in functions.values():
        if function.set and not function.is_local:
            entries[function.short_name][function.set] = function
    called = collections.defaultdict(set)
    for function in functions.values():
        for name in function.calls:
            called[name].add(function.set)
    sets = [BASELINE] + sets
    found = {function.set for function in functions.values() if function.set}
    if found != set(sets):
        problems.append('dispatched code is there for %s, expected: %s'
                        % (', '.join(sorted(found)) or 'no set', ', '.join(sets)))
    for name, by_set in sorted(entries.items()):
        for of_set in sets[1:]:
            if of_set not in by_set:
                problems.append('%s is missing for %s' % (name, of_set))
            elif not called[by_set[of_set].name] - {of_set}:
                problems.append('%s for %s is called by no dispatcher' % (name, of_set))
    for function in functions.values():
        if function.avx and function.set in (None, BASELINE):
            problems.append('not dispatched, but for AVX: %s has "%s"'
                            % (function.name, function.avx))

    print('%-20s%s' % ('bits of arithmetic', ''.join('%28s' % name for name in sets)))
    for name, by_set in sorted(entries.items()):
        cells = ''
        for of_set in sets:
            widths = widths_of(by_set[of_set], functions) if of_set in by_set else {}
            cells += '%28s' % (', '.join('%d: %d' % item for item in sorted(widths.items())) or '-')
            is_hot = name in hot or (name in hot_above and of_set != BASELINE)
            if is_hot and max(widths, default=0) < HOT_WIDTH[of_set]:
                problems.append('%s for %s has no arithmetic of %d bits'
                                % (name, of_set, HOT_WIDTH[of_set]))
        print('%-20s%s' % (name, cells))
    for name in hot + hot_above:
        if name not in entries:
            problems.append('there is no dispatched function %s; is it to be hot no more?' % name)
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('library')
    parser.add_argument('--sets', nargs='*', default=[])
    parser.add_argument('--hot', nargs='*', default=[])
    parser.add_argument('--hot-above', nargs='*', default=[])
    parser.add_argument('--objdump', default='objdump')
    options = parser.parse_args()
    functions = read(options.library, options.objdump)
    problems = check(functions, options.sets, options.hot, options.hot_above)
    for problem in problems:
        print('FAILED: ' + problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == '__main__':
    sys.exit(main())

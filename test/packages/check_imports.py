#!/usr/bin/python3
"""Checks that debian/control asks, in Depends, for the package of every Python module that the installed programs import.

Usage: check_imports.py. Prints one line for each problem; exit code 0 if there is none.
"""
import ast
import glob
import os
import re
import sys

import check_rosdep

ROOT = check_rosdep.ROOT


def installed():
    """The Python files that CMakeLists.txt installs."""
    with open(os.path.join(ROOT, 'CMakeLists.txt'), encoding='utf-8') as file:
        words = ' '.join(re.findall(r'install(?:_python)?\(((?:PROGRAMS|FILES|DIRECTORY)[^)]*)\)', file.read())).split()
    for path in (os.path.join(ROOT, word) for word in words if word.startswith('scripts/')):
        yield from glob.glob(path + '/**/*.py', recursive=True) if os.path.isdir(path) else [path]


def imports_of(path):
    with open(path, encoding='utf-8') as file:
        for node in ast.walk(ast.parse(file.read(), path)):
            if isinstance(node, ast.Import):
                yield from (alias.name for alias in node.names)
            elif isinstance(node, ast.ImportFrom) and not node.level:
                yield node.module


def problems(files, packages):
    own = {os.path.splitext(name)[0] for name in os.listdir(os.path.join(ROOT, 'scripts'))} | {'frontier_pilot'}
    for path in files:
        for module in sorted({name.split('.')[0] for name in imports_of(path)} - own - sys.stdlib_module_names):
            package = 'python3-' + module.lower().replace('_', '-')
            if package not in packages:
                yield f'debian/control: {package}, which {os.path.relpath(path, ROOT)} imports, is not in Depends'


def main():
    files = sorted(installed())
    found = list(problems(files, check_rosdep.asked_for('Depends')))
    print('\n'.join(found) if found else f'{len(files)} Python files, which import only what the package depends on')
    return 1 if found or not files else 0


if __name__ == '__main__':
    sys.exit(main())

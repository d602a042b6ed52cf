#!/usr/bin/python3
"""Checks, without building packages, that debian/*.install gives every installed file to exactly one package, and the right one.

Usage: check_lists.py INSTALLED, where INSTALLED is what `cmake --install BUILD --prefix INSTALLED` wrote. Prints one line for
each problem; exit code 0 if there is none.
"""
import fnmatch
import glob
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TRIPLET = 'x86_64-linux-gnu'  # any will do
# What catkin writes for workspaces, and the messages for Lisp: the packages are built without (debian/rules).
NOT_FOR_DEBIAN = re.compile(r'(\.catkin|\.rosinstall|(local_)?setup\.\w+|_setup_util\.py|env\.sh)$|share/common-lisp/')
# The first that fits says which package a file belongs to.
OWNERS = (
    (r'usr/lib/[^/]+/ros/libfrontier_pilot_rviz\.so|usr/share/frontier_pilot/plugins\.xml', 'frontier-pilot-rviz'),
    (r'usr/include/|.*\.(h|so|pc|cmake)$', 'libfrontier-pilot-dev'),
    (r'', 'frontier-pilot'),
)


def in_debian(path):
    """Where a file of a catkin workspace is when the packages are built: catkin and debian/rules see to that."""
    if path == 'lib/libfrontier_pilot_rviz.so':
        return f'usr/lib/{TRIPLET}/ros/libfrontier_pilot_rviz.so'
    if re.match(r'lib/(lib[^/]*|pkgconfig/.*)$', path):
        return f'usr/lib/{TRIPLET}/{path[4:]}'
    config = re.match(r'share/frontier_pilot/cmake/(frontier_pilot(Config|Targets|-(msg-)?extras).*)$', path)
    return f'usr/lib/{TRIPLET}/cmake/frontier_pilot/{config.group(1)}' if config else f'usr/{path}'


def installed(folder):
    for here, folders, names in os.walk(folder):
        for name in names + [name for name in folders if os.path.islink(os.path.join(here, name))]:
            path = os.path.relpath(os.path.join(here, name), folder)
            if not NOT_FOR_DEBIAN.search(path) and not path.endswith('.pyc'):
                yield in_debian(path)


def lists():
    """The patterns of each package."""
    for path in glob.glob(os.path.join(ROOT, 'debian', '*.install')):
        with open(path, encoding='utf-8') as file:
            yield os.path.basename(path)[:-len('.install')], file.read().split()


def fits(path, pattern):
    """As dh_install reads it: a folder stands for all that is in it, and an asterisk for no slash."""
    parts, wanted = path.split('/'), pattern.split('/')
    return len(parts) >= len(wanted) and all(map(fnmatch.fnmatchcase, parts, wanted))


def problems(files):
    patterns = dict(lists())
    for path in files:
        owners = [package for package in patterns if any(fits(path, pattern) for pattern in patterns[package])]
        right = next(package for expression, package in OWNERS if re.match(expression, path))
        if owners != [right]:
            yield f'{path} belongs to {right}, and debian/*.install gives it to {", ".join(sorted(owners)) or "no package"}'
    for package in patterns:
        for pattern in patterns[package]:
            if not any(fits(path, pattern) for path in files):
                yield f'debian/{package}.install: nothing is called {pattern}'


def main():
    files = sorted(installed(sys.argv[1]))
    found = list(problems(files))
    print('\n'.join(found) if found else f'{len(files)} files, each in the right package')
    return 1 if found or not files else 0


if __name__ == '__main__':
    sys.exit(main())

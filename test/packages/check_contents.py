#!/usr/bin/python3
"""Checks what the built packages hold: everything that the project installs, once and in the right package, nothing outside the
folders of packages, and nothing that leads back to where they were built.

Usage: check_contents.py DIRECTORY_OF_THE_PACKAGES PATH_OF_THE_BUILD. Prints one line for each problem; exit code 0 if there is none.
"""
import collections
import glob
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from check_lists import OWNERS, ROOT

ALLOWED = re.compile(r'usr/(include/frontier_pilot|lib/frontier_pilot|lib/python3/dist-packages/frontier_pilot|share/frontier_pilot|'
                     r'lib/[^/]+-linux-[^/]+|share/doc|share/lintian|share/python3/runtime\.d)/')
OF_DEBIAN = re.compile(r'usr/share/(doc|lintian|python3)/')
SHARE, PROGRAMS = 'usr/share/frontier_pilot', 'usr/lib/frontier_pilot'


def files_below(folder):
    """The files of the sources below this folder, with paths from the root."""
    return [str(path.relative_to(ROOT)) for path in sorted(pathlib.Path(ROOT, folder).rglob('*'))
            if path.is_file() and '__pycache__' not in path.parts]


def expected():
    """Where the files of the sources have to be."""
    cmake = pathlib.Path(ROOT, 'src/nodes/CMakeLists.txt').read_text(encoding='utf-8')
    for node in re.findall(r'^frontier_pilot_node\((\w+)', cmake, re.MULTILINE):
        yield f'{PROGRAMS}/{node}'
    cmake = pathlib.Path(ROOT, 'CMakeLists.txt').read_text(encoding='utf-8')
    installs = ' '.join(re.findall(r'install(?:_python)?\(([^)]*)\)', cmake))
    for script in re.findall(r'scripts/([\w./]+)', installs):
        path = pathlib.Path(ROOT, 'scripts', script)
        yield from (f'{PROGRAMS}/{name[len("scripts/"):]}' for name in (files_below(path) if path.is_dir() else [f'scripts/{script}']))
    for folder in ('launch', 'config', 'rviz', 'msg', 'srv', 'action'):
        yield from (f'{SHARE}/{name}' for name in files_below(folder))
    for name in files_below('include') + [f'include/frontier_pilot/{pathlib.Path(name).stem}.h' for name in files_below('msg')]:
        yield f'usr/{name}'
    yield from (f'{SHARE}/{name}' for name in ('package.xml', 'plugins.xml', 'docs/parameters.md'))


def contents(package, folder):
    """Unpacks a package, and names its files."""
    subprocess.run(['dpkg-deb', '-x', package, folder], check=True)
    for here, folders, names in os.walk(folder):
        for name in names + [name for name in folders if os.path.islink(os.path.join(here, name))]:
            yield os.path.relpath(os.path.join(here, name), folder)


def leads_back(path, build):
    """Why this file would look for something where it was built, or elsewhere than where Debian has its libraries."""
    if os.path.islink(path):
        return None if not os.readlink(path).startswith('/') else 'is an absolute link'
    with open(path, 'rb') as file:
        data = file.read()
    if not data.startswith(b'\x7fELF'):
        return f'names {build}' if build.encode() in data else None
    tags = subprocess.run(['readelf', '-d', path], stdout=subprocess.PIPE, text=True, check=True).stdout
    return 'has a RUNPATH' if re.search(r'\((RPATH|RUNPATH)\)', tags) else None


def problems(packages, build):
    owners = collections.defaultdict(list)
    for package in packages:
        name = os.path.basename(package).split('_')[0]
        with tempfile.TemporaryDirectory() as folder:
            for path in contents(package, folder):
                owners[path].append(name)
                if not ALLOWED.match(path):
                    yield f'{name} has {path}, which is no place for it'
                reason = leads_back(os.path.join(folder, path), build)
                if reason:
                    yield f'{name}: {path} {reason}'
    for path in sorted(set(expected()) | {path for path in owners if not OF_DEBIAN.match(path)}):
        right = next(package for expression, package in OWNERS if re.match(expression, path))
        if owners[path] != [right]:
            yield f'{path} belongs to {right}, and is in {", ".join(owners[path]) or "no package"}'
    print(f'{len(owners)} files in {len(packages)} packages')


def main():
    packages = [path for path in sorted(glob.glob(os.path.join(sys.argv[1], '*.deb'))) if '-dbgsym_' not in path]
    found = list(problems(packages, sys.argv[2]))
    print('\n'.join(found))
    return 1 if found or not packages else 0


if __name__ == '__main__':
    sys.exit(main())

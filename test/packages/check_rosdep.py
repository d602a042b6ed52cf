#!/usr/bin/python3
"""Checks with rosdep that every key of package.xml leads to packages of Debian 12, and that debian/control asks for them.

rosdep's list for Debian is a file of python3-rosdep2; of the lists that it would fetch, rosdep_base.yaml has what is needed.

Usage: check_rosdep.py. Prints one line for each problem; exit code 0 if there is none.
"""
import glob
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SOURCES = ('/usr/share/python3-rosdep2/debian.yaml', os.path.join(ROOT, 'test', 'packages', 'rosdep_base.yaml'))
# What Debian's list names besides what a key is about, and we do not use.
NOT_USED = {'libdynamicedt3d-dev', 'libgmock-dev', 'libgtest-dev', 'librosbag-dev', 'libroslib-dev', 'libtf2-msgs-dev', 'python3-diagnostic-updater',
            'libroscpp-core-dev'}
TO_BUILD, TO_RUN = ('buildtool_depend', 'build_depend', 'depend'), ('exec_depend',)


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def keys(*kinds):
    """The keys of package.xml in elements of these kinds."""
    return sorted({element.text for element in ElementTree.parse(os.path.join(ROOT, 'package.xml')).getroot() if element.tag in kinds})


def use_these_lists(folder):
    """Has rosdep use only our lists, and keep what it makes of them in this folder."""
    with open(os.path.join(folder, '10-lists.list'), 'w', encoding='utf-8') as file:
        file.writelines(f'yaml file://{source}\n' for source in SOURCES)
    index = os.path.join(folder, 'index.yaml')
    with open(index, 'w', encoding='utf-8') as file:
        file.write('%YAML 1.1\n---\ndistributions: {}\ntype: index\nversion: 4\n')
    os.environ.update(ROSDEP_SOURCE_PATH=folder, ROSDISTRO_INDEX_URL=f'file://{index}', ROS_HOME=folder, HOME=folder)
    os.environ.pop('ROS_DISTRO', None)


def packages_of(names):
    """The packages that each of these keys stands for; a key that rosdep does not know is missing."""
    found, key = {}, None
    for line in run('rosdep', 'resolve', *names, '--os=debian:bookworm').stdout.splitlines():
        heading = re.match(r'#ROSDEP\[(\S+)\]$', line)
        if heading:
            key = heading.group(1)
        elif key and not line.startswith(('#', 'ERROR')):
            found.setdefault(key, []).extend(line.split())
    return found


def known_to_debian(package):
    if run('dpkg-query', '-W', package).returncode == 0 or not glob.glob('/var/lib/apt/lists/*_Packages*'):
        return True  # without lists of packages, nothing can be said of those that are not installed
    return run('apt-cache', 'show', package).returncode == 0


def asked_for(field):
    """The packages in all fields of this name of debian/control."""
    with open(os.path.join(ROOT, 'debian', 'control'), encoding='utf-8') as file:
        fields = re.findall(rf'^{field}:((?:.*\n)(?: .*\n)*)', file.read(), re.MULTILINE)
    return {entry.split()[0] for text in fields for entry in text.replace('\n', ' ').split(',') if entry.split()}


def not_needed():
    """What keys name and we do not use: also the definitions of messages (ros-nav-msgs), but for those that ours are made of."""
    with open(os.path.join(ROOT, 'CMakeLists.txt'), encoding='utf-8') as file:
        ours = re.search(r'generate_messages\(DEPENDENCIES ([^)]*)\)', file.read()).group(1).split()
    definitions = {'ros-' + name.replace('_', '-') for name in ours} | {'ros-message-generation'}
    return lambda name: name in NOT_USED or (name.startswith('ros-') and name not in definitions)


def problems():
    if not os.path.exists(SOURCES[0]):
        yield 'rosdep is missing: apt-get install python3-rosdep2'
        return
    with tempfile.TemporaryDirectory() as folder:
        use_these_lists(folder)
        update = run('rosdep', 'update')
        if update.returncode != 0:
            yield f'rosdep update fails: {update.stdout}'
            return
        names = keys(*TO_BUILD, *TO_RUN, 'build_export_depend', 'test_depend', 'doc_depend')
        every = packages_of(names)
    for key in names:
        packages = every.get(key, ())
        if not packages:
            yield f'package.xml: rosdep knows no package of Debian 12 for {key}'
        for package in packages:
            if not known_to_debian(package):
                yield f'package.xml: {key} leads to {package}, which Debian 12 does not have'
    unused = not_needed()
    for kinds, field, other in ((TO_BUILD, 'Build-Depends', ('python3-',)), (TO_RUN, 'Depends', ('lib', 'ros-'))):
        for key in keys(*kinds):
            for package in every.get(key, ()):
                if not package.startswith(other) and not unused(package) and package not in asked_for(field):
                    yield f'debian/control: {package}, for {key} of package.xml, is not in {field}'


def main():
    found = list(problems())
    print('\n'.join(found) if found else 'every key of package.xml leads to packages of Debian 12')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())

"""How much of the modules the unit tests reach, from the counters of a build with SANITIZER=coverage.

Usage: coverage_table.py BUILD [--write-docs]. Prints a table, and writes it into docs/reliability.md if asked to; exit code 1
if the modules together have less than 95 % of the lines or 85 % of the branches.
"""
import collections
import datetime
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / 'docs/reliability.md'
BEGIN, END = '<!-- the table of the coverage begins -->', '<!-- the table of the coverage ends -->'
NO_MODULES = {'ros', 'gui', 'rviz', 'nodes', 'tools'}
LEAST = {'lines': 95.0, 'branches': 85.0}
WORST = 10


class Share:
    """How many lines and branches there are, and how many of them were reached."""

    def __init__(self):
        self.count = {'lines': 0, 'branches': 0}
        self.covered = {'lines': 0, 'branches': 0}

    def add(self, summary):
        for kind in self.count:
            self.count[kind] += summary[kind]['count']
            self.covered[kind] += summary[kind]['covered']

    def percent(self, kind):
        return 100.0 * self.covered[kind] / self.count[kind] if self.count[kind] else 100.0

    def missing(self, kind):
        return self.count[kind] - self.covered[kind]


def module_of(path):
    """The module of a source file, or None for what is none: tests, benchmarks, adapters, libraries."""
    parts = path.parts
    if parts[:2] == ('include', 'frontier_pilot'):
        return parts[2] if len(parts) > 3 and parts[2] not in NO_MODULES else None
    return parts[1] if parts[0] == 'src' and len(parts) > 2 and parts[1] not in NO_MODULES else None


def shares_of(export, root):
    """The shares by module and by file, from the summary that `llvm-cov export` gives."""
    modules, files = collections.defaultdict(Share), {}
    for file in export['data'][0]['files']:
        path = pathlib.Path(os.path.normpath(file['filename']))  # a compiler cache makes names relative to the build
        if root not in path.parents:
            continue
        path = path.relative_to(root)
        module = module_of(path)
        if module is None:
            continue
        modules[module].add(file['summary'])
        files[str(path)] = Share()
        files[str(path)].add(file['summary'])
    return modules, files


def total_of(modules):
    total = Share()
    for share in modules.values():
        for kind in total.count:
            total.count[kind] += share.count[kind]
            total.covered[kind] += share.covered[kind]
    return total


def row(name, share):
    return '| %s | %d | %.1f %% | %d | %.1f %% |' % (
        name, share.count['lines'], share.percent('lines'), share.count['branches'], share.percent('branches'))


def render(modules, files, date):
    lines = ['Measured on %s:' % date, '', '| module | lines | reached | branches | reached |', '|---|---|---|---|---|']
    lines += [row('`%s`' % name, modules[name]) for name in sorted(modules)]
    lines += [row('all', total_of(modules)), '', 'Most is left in:', '', '| file | lines left | branches left |', '|---|---|---|']
    worst = sorted(files, key=lambda name: (-files[name].missing('lines') - files[name].missing('branches'), name))
    lines += ['| `%s` | %d | %d |' % (name, files[name].missing('lines'), files[name].missing('branches')) for name in worst[:WORST]]
    return '\n'.join(lines)


def replaced(page, table):
    """The page with the table between its marks replaced; ValueError for a page without the marks."""
    begin, end = page.find(BEGIN), page.find(END)
    if begin < 0 or end < begin:
        raise ValueError('the page does not say where the table belongs')
    return page[:begin + len(BEGIN)] + '\n\n' + table + '\n\n' + page[end:]


def exported(build):
    """What `llvm-cov` says of all libraries and tests of the build together."""
    counters = build / 'all.profdata'
    raw = [str(path) for path in sorted((build / 'profiles').glob('*.profraw'))]
    subprocess.run(['llvm-profdata', 'merge', '-sparse', '-o', str(counters), *raw], check=True)
    objects = sorted(build.rglob('libfrontier_pilot_*.so')) + sorted((build / 'bin').glob('*_tests'))
    words = [word for path in objects for word in ('-object', str(path))]
    done = subprocess.run(['llvm-cov', 'export', '-summary-only', '-instr-profile', str(counters), *words[1:]], check=True,
                          stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    modules, files = shares_of(exported(build), ROOT)
    table = render(modules, files, datetime.date.today().isoformat())
    print(table)
    if '--write-docs' in sys.argv[2:]:
        PAGE.write_text(replaced(PAGE.read_text(), table))
    total = total_of(modules)
    return 0 if all(total.percent(kind) >= least for kind, least in LEAST.items()) else 1


if __name__ == '__main__':
    sys.exit(main())

"""Runs the fuzz targets one after the other."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from . import bags, build

FOLDER = build.ROOT / 'test' / 'fuzz'
BAGS = 'bags'
MOST_MEMORY = 2048  # [MB]
MOST_SECONDS = 25   # for one input
# The greatest length of an input where libFuzzer's, 4096 bytes, does not fit.
LONGEST = {'drive': 20000, 'image': 8192, 'octree': 16384, 'parameters': 8192, 'world': 8192}


def names():
    """All targets: the folders of the corpus."""
    return sorted(path.name for path in (FOLDER / 'corpus').iterdir() if path.is_dir())


def findings():
    folder = build.BUILD / 'findings'
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def options(name):
    """What a target needs whether it fuzzes or reads one file again."""
    words = ['-rss_limit_mb=%d' % MOST_MEMORY, '-timeout=%d' % MOST_SECONDS, '-artifact_prefix=%s/%s-' % (findings(), name)]
    dictionary = FOLDER / 'dictionaries' / (name + '.dict')
    return words + (['-dict=%s' % dictionary] if dictionary.exists() else [])


def environment(scratch):
    """A finding of a sanitizer ends the program; what a parser writes is written into memory where there is such a folder."""
    added = {'UBSAN_OPTIONS': 'print_stacktrace=1', 'ASAN_OPTIONS': 'detect_leaks=1:allocator_may_return_null=0',
             'OPENCV_LOG_LEVEL': 'SILENT', 'TMPDIR': scratch}
    return dict(os.environ, **added)


def scratch_folder():
    shared = pathlib.Path('/dev/shm')
    return tempfile.TemporaryDirectory(prefix='frontier_pilot_fuzz_', dir=shared if os.access(shared, os.W_OK) else None)


def fuzz(name, seconds, seed):
    """Fuzzes one target. Returns whether nothing was found, and a line about it."""
    found = build.BUILD / 'corpus' / name  # what led to new code; the next run begins with it
    found.mkdir(parents=True, exist_ok=True)
    before = set(findings().glob(name + '-*'))
    log = build.BUILD / ('%s.log' % name)
    words = [str(build.program(name)), *options(name), '-max_total_time=%d' % max(1, round(seconds)), '-seed=%d' % seed,
             '-max_len=%d' % LONGEST.get(name, 4096), '-print_final_stats=1', '-verbosity=1', str(found),
             str(FOLDER / 'corpus' / name)]
    with scratch_folder() as scratch, log.open('w') as out:
        code = subprocess.run(words, stdout=subprocess.DEVNULL, stderr=out, env=environment(scratch)).returncode
    text = log.read_text(errors='replace')
    if code == 0:
        return True, summary(text)
    inputs = sorted(set(findings().glob(name + '-*')) - before)
    return False, '%s; see %s%s' % (reason(text), log, ''.join('\n  scripts/fuzz --replay %s %s' % (path, name) for path in inputs))


def summary(text):
    executions = re.findall(r'stat::number_of_executed_units: (\d+)', text)
    speed = re.findall(r'stat::average_exec_per_sec: +(\d+)', text)
    edges = re.findall(r'cov: (\d+)', text)
    return '%s inputs, %s a second, %s edges' % tuple(values[-1] if values else '?' for values in (executions, speed, edges))


def reason(text):
    """The line that says what was found."""
    for pattern in (r'^.*runtime error: .*$', r'^does not hold: .*$', r'^SUMMARY: .*$', r'^.*(?:ERROR|what\(\)).*$'):
        lines = re.findall(pattern, text, re.MULTILINE)
        if lines:
            return lines[0].strip()
    return 'ended without a reason'


def run(wanted, seconds, seed):
    compiled = [name for name in wanted if name != BAGS]
    if compiled:
        build.make(compiled)
    failed = []
    for name in wanted:
        began = time.monotonic()
        held, words = bags.fuzz(seconds / len(wanted), seed, findings()) if name == BAGS else fuzz(name, seconds / len(wanted), seed)
        print('%s  %s (%d s): %s' % ('ok   ' if held else 'FAIL ', name, time.monotonic() - began, words), flush=True)
        failed += [] if held else [name]
    print('%d of %d targets without a finding%s' % (len(wanted) - len(failed), len(wanted),
                                                    '' if not failed else '; findings in ' + ', '.join(failed)))
    return 1 if failed else 0


def replay(path, name):
    if name == BAGS:
        held, words = bags.replay(path)
        print(words)
        return 0 if held else 1
    build.make([name])
    path = str(pathlib.Path(path).resolve())
    with scratch_folder() as scratch:
        code = subprocess.run([str(build.program(name)), *options(name), path], env=environment(scratch)).returncode
    print('%s: %s' % (name, 'read or refused as it has to be' if code == 0 else 'a finding'), file=sys.stderr)
    return 0 if code == 0 else 1

"""Breaks rosbags and has map_log read them, each in a process of its own."""
import hashlib
import os
import pathlib
import random
import resource
import struct
import subprocess
import tempfile
import time

from .build import ROOT, BuildError

SEEDS = ROOT / 'test' / 'fuzz' / 'corpus' / 'bags'
MOST_SECONDS = 60       # for one bag
MOST_MEMORY = 6 << 30   # of the address space of one process [bytes]
FIELDS = (b'op=', b'chunk_pos=', b'index_pos=', b'conn=', b'conn_count=', b'chunk_count=', b'count=', b'size=', b'compression=',
          b'topic=', b'type=', b'md5sum=', b'time=', b'start_time=', b'end_time=', b'ver=')
NUMBERS = (0, 1, 2, 5, 255, 65535, 2 ** 31 - 1, 2 ** 31, 2 ** 32 - 2, 2 ** 32 - 1)


def programs():
    """map_log in the builds that have the nodes, the newest first."""
    named = [os.environ[name] for name in ('FRONTIER_PILOT_BUILD', 'FRONTIER_PILOT_TEST_BUILD') if os.environ.get(name)]
    folders = [pathlib.Path(name) for name in named] or [ROOT / 'build', ROOT / 'build' / 'test']
    paths = [folder / 'devel/lib/frontier_pilot/map_log' for folder in folders]
    return sorted((path for path in paths if path.exists()), key=lambda path: -path.stat().st_mtime)


def find_program():
    found = programs()
    if not found:
        raise BuildError('bags: no build with map_log; scripts/run and scripts/test make one')
    return found[0]


def somewhere(data, draw):
    """A place to break: often behind the name of a field, where a number stands."""
    if draw.random() < 0.5:
        field = draw.choice(FIELDS)
        places = [at for at in range(len(data)) if data.startswith(field, at)] if field in data else []
        if places:
            return min(len(data) - 1, draw.choice(places) + len(field) + draw.randint(-len(field) - 4, 4))
    return draw.randrange(len(data))


def broken_once(data, draw):
    at, kind = somewhere(data, draw), draw.randrange(6)
    length = draw.choice((1, 2, 4, 8, 64, 1024))
    if kind == 0:
        data[at] ^= 1 << draw.randrange(8)
    elif kind == 1:
        data[at:at + 4] = struct.pack('<I', draw.choice(NUMBERS))
    elif kind == 2:
        data[at:at + length] = bytes(draw.randrange(256) for _ in range(length))
    elif kind == 3:
        del data[at:at + length]
    elif kind == 4:
        data[at:at] = data[at:at + length]
    else:
        del data[at:]


def broken(data, draw):
    data = bytearray(data)
    for _ in range(draw.choice((1, 1, 1, 2, 4, 16))):
        if data:
            broken_once(data, draw)
    return bytes(data)


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def problem_of(program, path, folder):
    """What is wrong with the way in which map_log reads a bag; None if nothing is."""
    out = pathlib.Path(folder) / 'out'
    out.mkdir()
    try:
        done = subprocess.run([str(program), str(path), '--out', str(out / 'map')], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, timeout=MOST_SECONDS, preexec_fn=limit)
        made = sorted(path.name for path in out.iterdir())
    except subprocess.TimeoutExpired:
        return 'map_log takes longer than %d s' % MOST_SECONDS
    finally:
        for path in out.iterdir():
            path.unlink()
        out.rmdir()
    said = done.stderr.decode(errors='replace').strip()
    if done.returncode == 0:
        return None if 'map.bt' in made else 'map_log has made no map, and says nothing of it'
    if done.returncode != 1 or not said.startswith('map_log: '):
        return 'map_log has ended with %d: %s' % (done.returncode, said[:300])
    return 'map_log has made %s of a bag that it refuses' % ', '.join(made) if made else None


def fuzz(seconds, seed, findings):
    """Reads broken bags for `seconds`. Returns whether nothing was found, and a line about it."""
    program, draw, count = find_program(), random.Random(seed), 0
    bags = [path.read_bytes() for path in sorted(SEEDS.iterdir())]
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix='frontier_pilot_fuzz_') as folder:
        path = pathlib.Path(folder) / 'broken.bag'
        while time.monotonic() - began < seconds:
            data = broken(draw.choice(bags), draw)
            path.write_bytes(data)
            count += 1
            problem = problem_of(program, path, folder)
            if problem is not None:
                kept = findings / ('bags-%s.bag' % hashlib.sha1(data).hexdigest()[:16])
                kept.write_bytes(data)
                return False, '%s\n  scripts/fuzz --replay %s bags' % (problem, kept)
    return True, '%d inputs, %.1f a second' % (count, count / seconds)


def replay(path):
    with tempfile.TemporaryDirectory(prefix='frontier_pilot_fuzz_') as folder:
        problem = problem_of(find_program(), pathlib.Path(path).resolve(), folder)
    return problem is None, 'bags: ' + (problem or 'read or refused as it has to be')

#!/usr/bin/env python3
"""What the caller of a shell script has exported does not matter to it."""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]


def scripts_with_a_root():
    paths = [*(ROOT / 'scripts').iterdir(), ROOT / 'test/consumers/run', ROOT / 'test/packages/run']
    return sorted(path.relative_to(ROOT) for path in paths if path.is_file() and '\nroot=' in path.read_text())


class Surroundings(unittest.TestCase):
    def root_of(self, script, **environment):
        """What the script takes for the root of the sources, called from there; it ends with that."""
        with tempfile.NamedTemporaryFile('w') as before:
            before.write('trap \'[ -z "${root:-}" ] || { printf %s "$root"; exit 0; }\' DEBUG\n')
            before.flush()
            done = subprocess.run([str(script)], cwd=ROOT, timeout=60, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True,
                                  env=dict(os.environ, BASH_ENV=before.name, **environment))
        return done.stdout

    def test_folders_in_which_cd_looks_as_well_do_not_matter(self):
        self.assertGreater(len(scripts_with_a_root()), 4)
        for script in scripts_with_a_root():
            with self.subTest(script=str(script)):
                self.assertEqual(self.root_of(script, CDPATH='.:/'), str(ROOT))


if __name__ == '__main__':
    unittest.main()

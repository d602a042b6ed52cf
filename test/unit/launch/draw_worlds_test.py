#!/usr/bin/env python3
"""The files of the worlds that the package draws."""
import errno
import os
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
import draw_worlds  # noqa: E402


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def contents(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir()}

    def test_a_world_that_cannot_be_written_stays_as_it_was(self):
        """[FLT-1] On a full disk, and after a Ctrl-C."""
        plan, start = draw_worlds.small()
        draw_worlds.save(str(self.folder), 'small', plan, start, 'Two rooms.')
        before = self.contents()
        self.assertEqual(set(before), {'small.pgm', 'small.yaml'})
        opened = open

        def cut_off(failure, ending):
            def open_and_fail(path, mode):
                file = opened(path, mode)
                if not path.endswith(ending):
                    return file
                handle = mock.MagicMock(wraps=file)
                handle.__enter__.return_value = handle
                handle.__exit__.side_effect = lambda *_: file.close()
                handle.write.side_effect = failure
                return handle
            return open_and_fail

        full = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        for failure, ending in ((full, 'pgm.part'), (KeyboardInterrupt(), 'pgm.part'), (full, 'yaml.part')):
            plan.solid[:, 0] ^= True  # another picture
            with mock.patch('builtins.open', cut_off(failure, ending)), self.assertRaises(type(failure)):
                draw_worlds.save(str(self.folder), 'small', plan, start, 'Two rooms.')
            self.assertEqual(self.contents(), before, (failure, ending))

    def test_the_worlds_of_the_package_are_those_that_are_drawn(self):
        plan, start = draw_worlds.small()
        draw_worlds.save(str(self.folder), 'small', plan, start, draw_worlds.small.__doc__)
        worlds = pathlib.Path(draw_worlds.__file__).parents[1] / 'config/worlds'
        for name, content in self.contents().items():
            self.assertEqual(content, (worlds / name).read_bytes(), name)


if __name__ == '__main__':
    unittest.main()

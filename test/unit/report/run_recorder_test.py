#!/usr/bin/env python3
"""The parameters of run_recorder, and what it does when the master answers nonsense."""
import importlib.machinery
import importlib.util
import io
import json
import os
import pathlib
import tempfile
import unittest
import xmlrpc.client
import xml.parsers.expat
from unittest import mock

import folder_case  # noqa: F401: finds the scripts

PATH = str(pathlib.Path(__file__).resolve().parents[3] / 'scripts/run_recorder')


def load():
    """The program as a module, although its name has no ending."""
    loader = importlib.machinery.SourceFileLoader('run_recorder_program', PATH)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class Parameters(unittest.TestCase):
    def read(self, given):
        program = load()
        with mock.patch.object(program.rospy, 'get_param', return_value=given), \
                mock.patch.object(program.rospy, 'get_name', return_value='/run_recorder'):
            return program.read_parameters()

    def test_a_single_value_in_place_of_parameters_is_said(self):
        """[FLT-1]"""
        for given in (5, 'text', [1, 2]):
            self.assertEqual(self.read(given)[1], ['/run_recorder is a single value, not a dictionary of parameters'])

    def test_numbers_as_other_programs_write_them_are_numbers(self):
        values, problems = self.read({'min_space': '1e3', 'size': '5e2'})
        self.assertEqual((values['min_space'], values['size'], problems), (1000, 500, []))
        self.assertEqual(self.read({'min_space': '1e10'})[1], ['min_space: must be between 1 and 1e+09, not 1e+10'])
        self.assertEqual(self.read({'min_space': 'much'})[1], ["min_space: must be a number, not 'much'"])

    def test_what_is_not_given_has_its_default(self):
        values, problems = self.read({'size': 100})
        self.assertEqual((values['size'], values['runs'], problems), (100, 10, []))


class Master(unittest.TestCase):
    def test_parameters_that_the_master_cannot_give_are_left_out_of_the_record(self):
        """[FLT-1] [REC-1] The master cannot write what is in some of them, or dies in the middle of its answer."""
        for failure in (xmlrpc.client.Fault(1, 'cannot marshal'), xml.parsers.expat.ExpatError('no element found')):
            with self.subTest(failure=failure):
                program = load()
                recorder = program.RunRecorder.__new__(program.RunRecorder)
                recorder.nodes, recorder.info = mock.Mock(), mock.Mock()
                recorder.nodes.master.getParam.side_effect = failure
                recorder.names, recorder.run, recorder.parameters = {}, '/run', {'robot': ''}
                with mock.patch.object(program.rospy, 'get_namespace', return_value='/'), \
                        mock.patch('sys.stderr', io.StringIO()) as said:
                    recorder.say('start')
                self.assertEqual(json.loads(recorder.info.publish.call_args[0][0])['parameters'], {})
                self.assertRegex(said.getvalue(), r'^run_recorder: the record lacks the parameters, .*\n$')


class Caller(unittest.TestCase):
    def test_a_run_that_begins_after_its_folder_was_removed_is_found_by_the_caller(self):
        """[REC-1]"""
        program = load()
        recorder = program.RunRecorder.__new__(program.RunRecorder)
        with tempfile.TemporaryDirectory() as caller, mock.patch.dict(os.environ, FRONTIER_PILOT_RUN=caller):
            for name in 'first', 'second', 'third':
                recorder.run = os.path.join(caller, name)
                os.mkdir(recorder.run)
                recorder.show_to_the_caller()
                if name == 'first':
                    os.rmdir(recorder.run)
            self.assertEqual(os.readlink(os.path.join(caller, 'recorded')), os.path.join(caller, 'second'))
            self.assertEqual(sorted(os.listdir(caller)), ['recorded', 'second', 'third'])


if __name__ == '__main__':
    unittest.main()

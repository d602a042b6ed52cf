#!/usr/bin/env python3
"""How the attack calls services, whose answers are stand-ins."""
import pathlib
import sys
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
try:
    from std_srvs.srv import SetBoolResponse
    from run_attack import services
except ImportError as missing:
    raise unittest.SkipTest('needs the messages of a build: %s' % missing)


class Explore(unittest.TestCase):
    """[ARB-8]"""

    def test_asks_again_an_explorer_that_is_being_started_or_has_not_heard_of_the_clear(self):
        answers = [None, SetBoolResponse(True, 'exploration enabled; the robot is stopped, and clearing the stop pauses it'),
                   SetBoolResponse(True, 'exploration enabled; it waits until the arbiter says whether the robot was stopped meanwhile'),
                   SetBoolResponse(True, 'exploration enabled')]
        with mock.patch.object(services, 'switch', side_effect=answers) as switch:
            self.assertEqual(services.explore(True, '/robot1/').message, 'exploration enabled')
        self.assertEqual(switch.call_args_list, 4 * [mock.call('/robot1/set_exploration_enabled', True)])

    def test_asks_once_for_a_pause(self):
        for answer in SetBoolResponse(True, 'exploration paused; the robot is stopped'), None:
            with mock.patch.object(services, 'switch', side_effect=[answer]):
                self.assertIs(services.explore(False), answer)

    def test_gives_the_last_answer_of_an_explorer_that_stays_stopped_or_away(self):
        for answer in SetBoolResponse(True, 'exploration enabled; the robot is stopped, and clearing the stop pauses it'), None:
            with mock.patch.object(services, 'switch', return_value=answer), mock.patch.object(services, 'STOP_IS_KNOWN', 0.1):
                self.assertIs(services.explore(True), answer)


if __name__ == '__main__':
    unittest.main()

#!/usr/bin/env python3
"""An explorer that shares a building with another robot: what that one claims is respected, until it falls silent."""
import math

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from frontier_pilot.msg import ExplorerStatus as Status
from frontier_pilot.msg import FleetClaim, FleetClaims

from explorer_case import ExplorerCase
from wire import Record, wait_for


class ExplorerTeam(ExplorerCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('explorer_team')
        super().setUpClass()
        cls.heard = Record('/fleet/claims', FleetClaims)
        cls.diagnostics = Record('/diagnostics', DiagnosticArray)
        cls.publisher = rospy.Publisher('/fleet/claims', FleetClaims, queue_size=20)

    def explore(self, **parameters):
        self.heard.items.clear()
        self.diagnostics.items.clear()
        parameters.setdefault('fleet', {'name': 'robot_1'})
        super().explore(**parameters)

    def own(self):
        return [claims for _, claims in list(self.heard.items) if claims.robot == 'robot_1']

    def tell(self, places, version=FleetClaims.VERSION, frame='map', robot='robot_2'):
        """One message of a second robot that sees each of the places at once."""
        message = FleetClaims(version=version, robot=robot, valid_for=10.0)
        message.header.frame_id, message.header.stamp = frame, rospy.Time.now()
        message.claims = [FleetClaim(x=x, y=y, cost=0.0) for x, y in places]
        self.publisher.publish(message)

    def what_the_team_says(self):
        """The explorer's last diagnostics of its team."""
        said = [(status.message, [(value.key, value.value) for value in status.values])
                for _, array in list(self.diagnostics.items) for status in array.status if status.name.endswith(': team')]
        return said[-1:]

    def refused(self, word):
        return any(word in value.key for _, array in list(self.diagnostics.items)
                   for status in array.status for value in status.values)

    # [MUL-2]
    def test_an_explorer_says_what_it_claims_at_least_once_a_second_in_few_bytes(self):
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.explore()
        self.assertTrue(wait_for(lambda: any(claims.claims for claims in self.own()), 30.0))
        count = len(self.own())
        rospy.sleep(4.0)
        self.assertGreaterEqual(len(self.own()) - count, 4)
        last = self.own()[-1]
        self.assertEqual((FleetClaims.VERSION, 'map', 10.0), (last.version, last.header.frame_id, last.valid_for))
        self.assertTrue(all(claim.cost >= 0.0 for claim in last.claims))
        self.assertLessEqual(2 * (100 + 12 * 40), 2000, 'two messages a second with the most claims')

    # [MUL-2]
    def test_a_claim_is_respected_until_the_robot_falls_silent(self):
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.explore()
        self.assertTrue(wait_for(lambda: any(claims.claims for claims in self.own()), 30.0))
        places = [(claim.x, claim.y) for claim in self.own()[-1].claims]
        began = rospy.Time.now()
        while not self.comes(lambda status: status.reason == Status.LEFT_TO_OTHERS, 0.5):
            self.assertLess((rospy.Time.now() - began).to_sec(), 30.0, (self.status.last.reason_text, places, self.what_the_team_says(),
                                                                        self.publisher.get_num_connections()))
            # What comes into sight once the first places are left to the other robot is claimed in turn.
            places = sorted({(claim.x, claim.y) for claims in self.own() for claim in claims.claims})[-40:]
            self.tell(places)
        self.assertTrue(wait_for(lambda: not self.own()[-1].claims))
        self.status.items.clear()
        self.tell(places)
        silent = rospy.Time.now()
        self.assertTrue(self.comes(lambda status: status.state == Status.NAVIGATING, 20.0))
        self.assertGreater((rospy.Time.now() - silent).to_sec(), 9.0)

    # [MUL-2] [FLT-1]
    def test_other_versions_frames_and_nonsense_are_refused_with_a_word_and_counted(self):
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.explore()
        self.assertTrue(wait_for(lambda: any(claims.claims for claims in self.own()), 30.0))
        places = [(claim.x, claim.y) for claim in self.own()[-1].claims]
        self.status.items.clear()
        cases = (('another version of the protocol', {'version': 2}),
                 ('not finite', {'places': places + [(math.nan, 0.0)]}),
                 ("in the frame 'elsewhere'", {'frame': 'elsewhere'}),
                 ("another robot with this one's name", {'robot': 'robot_1'}))
        for word, change in cases:
            # Told until it is refused: the explorer may not be connected yet.
            self.assertTrue(wait_for(lambda: self.tell(**{'places': places, **change}) or self.refused(word)), word)
        self.assertFalse(self.comes(lambda status: status.reason == Status.LEFT_TO_OTHERS, 3.0))

    # [MUL-2]
    def test_an_explorer_whose_place_in_the_common_frame_is_unknown_works_alone(self):
        self.explore(fleet={'name': 'robot_1', 'frame': 'building'})
        self.assertTrue(self.comes(lambda status: status.state == Status.NAVIGATING))
        rospy.sleep(2.0)
        self.assertFalse(self.own())


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'explorer_team', ExplorerTeam)

#!/usr/bin/env python3
"""Bounds that are drawn in rviz: the clicks of its Publish Point."""
import rospy
import rostest
import tf2_ros
from frontier_pilot.msg import ExplorerStatus as Status
from frontier_pilot.srv import SetBounds
from geometry_msgs.msg import PointStamped, Polygon, TransformStamped
from rosgraph_msgs.msg import Log
from std_srvs.srv import Trigger

from explorer_case import ExplorerCase
from wire import Record, call, wait_for

RIGHT = [(-0.9, -2.0), (5.0, -2.0), (5.0, 2.0), (-0.9, 2.0)]  # without the left end
SHIFT = 10.0  # of the frame `elsewhere` in the map [m]


class ExplorerClicks(ExplorerCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('explorer_clicks')
        super().setUpClass()
        cls.clicks = rospy.Publisher('clicked_point', PointStamped, queue_size=20)
        cls.log = Record('/rosout', Log)
        cls.frames = tf2_ros.StaticTransformBroadcaster()
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'map', 'elsewhere'
        transform.transform.translation.x = SHIFT
        transform.transform.rotation.w = 1.0
        cls.frames.sendTransform(transform)

    def explore(self, **parameters):
        super().explore(**parameters)
        self.assertTrue(wait_for(lambda: self.robot.goals and self.clicks.get_num_connections() > 0))
        self.log.items.clear()

    def click(self, x, y, frame='map', shift=0.0):
        point = PointStamped()
        point.header.frame_id, point.header.stamp = frame, rospy.Time.now()
        point.point.x, point.point.y = x - shift, y
        self.clicks.publish(point)

    def corners_are(self, corners):
        return wait_for(lambda: self.status.last and self.matches(self.status.last.clicked_corners, corners))

    @staticmethod
    def matches(polygon, corners):
        return len(polygon.points) == len(corners) and all(
            abs(p.x - x) < 1e-4 and abs(p.y - y) < 1e-4 for p, (x, y) in zip(polygon.points, corners))

    def is_logged(self, words):
        return wait_for(lambda: any(words in message.msg for _, message in list(self.log.items)))

    def drawn(self):
        """The corners of the polygon that is being drawn in rviz."""
        if self.markers.last is None:
            return -1
        lines = [m for m in self.markers.last.markers if m.ns == 'new bounds' and m.points]
        return len(lines[0].points) if lines else 0

    # [EXP-10]
    def test_clicks_draw_a_polygon_that_a_click_at_its_first_corner_puts_into_force(self):
        self.explore()
        for x, y in RIGHT:
            self.click(x, y)
        self.assertTrue(self.corners_are(RIGHT), self.status.last)
        self.assertEqual(0, len(self.status.last.stay_within.points), 'not closed yet')
        self.assertTrue(wait_for(lambda: self.drawn() == 4))
        self.click(-0.8, -1.7)
        self.assertTrue(wait_for(lambda: self.matches(self.status.last.stay_within, RIGHT)), self.status.last)
        self.assertEqual(0, len(self.status.last.clicked_corners.points))
        self.assertTrue(self.is_logged('new bounds by clicks: stay within: 4 corners, 23.6 m2'))
        self.assertTrue(wait_for(lambda: self.drawn() == 0))
        self.assertTrue(self.comes(lambda status: status.reason in (Status.BOUNDS_CHANGED, Status.GOAL_SENT)))

    # [EXP-10]
    def test_clicks_are_taken_in_their_own_frame_and_refused_in_one_that_nobody_knows(self):
        self.explore()
        self.click(*RIGHT[0], frame='elsewhere', shift=SHIFT)
        self.click(*RIGHT[1], frame='nowhere')
        self.click(*RIGHT[2], frame='elsewhere', shift=SHIFT)
        self.assertTrue(self.corners_are([RIGHT[0], RIGHT[2]]), self.status.last)
        self.assertTrue(self.is_logged('clicked point refused'), [m.msg for _, m in self.log.items])

    # [EXP-10]
    def test_a_polygon_that_crosses_itself_is_refused_as_by_the_service(self):
        self.explore()
        for corner in (0, 2, 1, 3, 0):
            self.click(*RIGHT[corner])
        self.assertTrue(self.is_logged('stay_within: crosses or touches itself; the bounds are as before'))
        self.assertTrue(self.corners_are([]))
        self.assertEqual(0, len(self.status.last.stay_within.points))

    # [EXP-10]
    def test_an_unfinished_polygon_is_taken_back_by_a_call_of_the_service(self):
        self.explore()
        self.click(*RIGHT[0])
        self.assertTrue(self.corners_are(RIGHT[:1]))
        self.assertTrue(call('frontier_explorer/set_bounds', SetBounds, Polygon(), []).success)
        self.assertTrue(self.corners_are([]))
        self.click(*RIGHT[1])
        self.assertTrue(self.corners_are(RIGHT[1:2]))
        answer = call('frontier_explorer/clear_bounds', Trigger)
        self.assertEqual((True, 'stay within: everywhere'), (answer.success, answer.message))
        self.assertTrue(self.corners_are([]))


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'explorer_clicks', ExplorerClicks)

"""A process that publishes `cmd_vel` beside the arbiter until it is ended.

Usage: python3 -m run_attack.stranger
"""
import rospy
from geometry_msgs.msg import Twist, Vector3

from leftovers import end_with_the_parent

NAME = 'attack_stranger'

if __name__ == '__main__':
    end_with_the_parent()
    rospy.init_node(NAME)
    publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1)
    rate = rospy.Rate(50.0)
    try:
        while not rospy.is_shutdown():
            publisher.publish(Twist(angular=Vector3(0.0, 0.0, 0.3)))
            rate.sleep()
    except rospy.ROSInterruptException:
        pass

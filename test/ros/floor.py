#!/usr/bin/env python3
"""Publishes the simulator's world as `map`, under the node name that it is given, as a map server does."""
import rospy
from nav_msgs.msg import OccupancyGrid

START = (0.7, 0.8)  # of the robot in the world; the origin of map and odom

rospy.init_node('floor')
grid = rospy.wait_for_message('simulator/world', OccupancyGrid)
grid.header.frame_id = 'map'
grid.info.origin.position.x, grid.info.origin.position.y = -START[0], -START[1]
publisher = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
publisher.publish(grid)
rospy.spin()

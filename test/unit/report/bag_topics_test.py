#!/usr/bin/env python3
"""Topics of a recorded drive, as play.launch reads them."""
import io
import unittest

import folder_case  # noqa: F401: finds the scripts
from bag_topics import BagError, Topic
from nav_msgs.msg import Odometry


class Damage(unittest.TestCase):
    def test_a_message_that_cannot_be_read_is_named_by_its_topic(self):
        buffer = io.BytesIO()
        Odometry().serialize(buffer)
        topic = Topic('/odom', Odometry)
        topic.raw = [(0.0, buffer.getvalue()), (0.1, buffer.getvalue()[:40])]
        self.assertEqual(topic.message(0), Odometry())
        for read in (lambda: topic.message(1), lambda: list(topic.messages())):
            with self.assertRaisesRegex(BagError, '/odom: a message cannot be read'):
                read()


if __name__ == '__main__':
    unittest.main()

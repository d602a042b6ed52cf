#!/usr/bin/env python3
"""Shows that each rule of check_architecture.py can fail, and that a good house passes."""
import pathlib
import tempfile
import unittest

import check_architecture
from cpp_functions import functions_of

GOOD = {
    'include/frontier_pilot/core/grid.h': '#pragma once\n#include <vector>\n',
    'include/frontier_pilot/ros/names.h': 'constexpr const char* kMap = "map";\n',
    'src/core/grid.cpp': '#include "frontier_pilot/core/grid.h"\nint f(int x) {\n  return x;\n}\n',
    'src/planning/plan.cpp': '#include <ompl/base/Planner.h>\n#include "frontier_pilot/core/grid.h"\n',
    'src/ros/mapper_adapter.cpp': '#include <ros/ros.h>\nvoid f(ros::NodeHandle& n) { n.advertise<Map>(names::kMap, 1); }\n',
    'src/nodes/mapper_node.cpp': '#include "frontier_pilot/ros/names.h"\nint main() {\n  return 0;\n}\n',
    'docs/requirements.md': '- [x] ARB-1 order\n- [ ] ARB-2 later\n',
    'test/unit/arbiter/order_test.cpp': '// [ARB-1]\n',
}


def problems_with(changes):
    """What is found in the good house with some files changed."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in {**GOOD, **changes}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return '\n'.join(check_architecture.problems(root))


class CheckArchitecture(unittest.TestCase):
    def expect(self, part, changes):
        self.assertIn(part, problems_with(changes))

    def test_a_good_house_passes(self):
        self.assertEqual('', problems_with({}))

    def test_a_module_that_includes_another_is_found(self):
        self.expect('may only use core', {'src/planning/bad.cpp': '#include "frontier_pilot/mapping/map.h"\n'})

    def test_core_that_includes_a_module_is_found(self):
        self.expect('may only use', {'src/core/bad.cpp': '#include "frontier_pilot/sim/world.h"\n'})

    def test_ros_in_a_module_is_found(self):
        for include in ('ros/ros.h', 'nav_msgs/Path.h', 'tf2_ros/buffer.h', 'frontier_pilot/SpinAction.h'):
            self.expect('ROS belongs to', {'src/sim/bad.cpp': '#include <%s>\n' % include})

    def test_a_library_out_of_its_module_is_found(self):
        self.expect('OMPL belongs to', {'src/mapping/bad.cpp': '#include <ompl/base/Planner.h>\n'})
        self.expect('OctoMap belongs to', {'src/planning/bad.cpp': '#include <octomap/octomap.h>\n'})
        self.expect('Qt belongs to', {'src/teleop/bad.cpp': '#include <QWidget>\n'})

    def test_a_folder_that_nobody_planned_is_found(self):
        self.expect('not part of the house', {'src/utils/bad.cpp': '\n'})

    def test_a_reach_into_another_folder_is_found(self):
        self.expect('reaches into', {'src/sim/bad.cpp': '#include "../core/grid.h"\n'})

    def test_a_clock_a_sleep_or_a_print_in_a_module_is_found(self):
        for call in ('std::chrono::steady_clock::now()', 'usleep(1)', 'std::cout << 1', 'std::random_device()'):
            self.expect('reads a clock', {'src/sim/bad.cpp': 'void f() { %s; }\n' % call})

    def test_a_clock_in_a_comment_or_a_string_is_none(self):
        self.assertEqual('', problems_with({'src/sim/good.cpp': '// Clock::now()\nauto s = "Clock::now()";\n'}))

    def test_a_long_file_is_found(self):
        self.expect('300 is the limit', {'src/sim/bad.cpp': '\n' * 300})
        self.expect('150 is the limit', {'src/ros/mapper_adapter.cpp': '\n' * 150})
        self.expect('25 is the limit', {'src/nodes/mapper_node.cpp': '\n' * 25})

    def test_a_long_function_is_found(self):
        self.expect('60 is the limit', {'src/sim/bad.cpp': 'int f(int x) {\n' + '  ++x;\n' * 60 + '}\n'})

    def test_a_topic_or_a_frame_outside_of_names_is_found(self):
        for line in ('n.advertise<std_msgs::Bool>("stalled", 1);', 'n.subscribe("map", 1, &f);',
                     'n.serviceClient<std_srvs::Empty>("reset");', 'header.frame_id = "odom";',
                     'actionlib::SimpleActionServer<A> server("spin", false);'):
            self.expect('names.h', {'src/ros/bad.cpp': 'void f() { %s }\n' % line})

    def test_a_subscription_that_does_not_check_what_it_reads_is_found(self):  # [FLT-1]
        for call in ('node_.subscribe<Twist>(topic, 1, f)', 'node.subscribe(names::kScan, 1, &Node::f, this)',
                     'ros::NodeHandle().subscribe(topic, 1, f)'):
            self.expect('no checkedSubscription', {'src/ros/bad.cpp': 'void f() { %s; }\n' % call})
        self.assertEqual('', problems_with({'src/ros/good.cpp': 'void f() { s = node_.subscribe(options); }\n'}))

    def test_a_built_requirement_that_no_test_cites_is_found(self):
        self.expect('no test cites [ARB-2]', {'docs/requirements.md': '- [x] ARB-1 order\n- [x] ARB-2 now\n'})

    def test_a_citation_of_what_is_not_required_is_found(self):
        self.expect('does not have', {'test/unit/arbiter/bad_test.cpp': '// [ARB-99]\n'})


class FunctionLengths(unittest.TestCase):
    def test_functions_are_measured_from_name_to_brace(self):
        text = ('namespace a {\nclass B {\n public:\n  int f() const { return 1; }\n};\n'
                'B::B(int x)\n    : x_{x}, y_(2) {\n  if (x) {\n    y();\n  }\n}\n}  // namespace a\n')
        self.assertEqual([1], [n for name, n in functions_of(text) if name == 'f'])
        self.assertEqual([6], [n for name, n in functions_of(text) if name == 'B::B'])

    def test_braces_in_strings_and_comments_do_not_count(self):
        self.assertEqual([('f', 3)], functions_of('void f() {\n  g("}"); // }\n}\n'))


if __name__ == '__main__':
    unittest.main()

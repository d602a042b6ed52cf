#pragma once

namespace frontier_pilot::bench {

/// What explore_bench prints for --help.
constexpr const char* kUsage =
    "usage: explore_bench [options] WORLD.yaml ...\n"
    "Explores worlds with simulator, mapper, navigator, explorer and arbiter in one process, faster than real time.\n"
    "  --seeds A-B        seeds to run (1-5)\n"
    "  --robots N         so many robots, which share their maps; the others start within 3 m of the first one (1)\n"
    "  --off FROM UNTIL   the last robot is off from one time to the other [s], for good if the second is not later\n"
    "  --no-agreement     the robots share maps only, and do not agree who goes where\n"
    "  --no-rule          the robots do not agree who goes first where there is no room for two\n"
    "  --robot NAME       one of config/robots/, or the path of a file like those; without it, a Burger with a "
    "scanner\n"
    "                     that measures 10 times a second all at once up to 8 m\n"
    "  --at-once          the robot's scanner measures all beams at once\n"
    "  --skewed           beams of rolling scans are not put where the robot was at their time\n"
    "  --limits NAME      instead of the robot's own: burger (0.22 m/s) or fast (0.5 m/s)\n"
    "  --strategy NAME    tour (default), greedy or nearest\n"
    "  --start X Y YAW    start pose in the world [m, m, rad]; the world's own otherwise\n"
    "  --until SHARE      stop at this explored share instead of DONE\n"
    "  --limit SECONDS    of simulated time, 7200\n"
    "  --odom-noise       the simulator's odometry noise; the mapper then matches scans and closes loops\n"
    "  --latency SECONDS  from a measurement to those who use it, 0\n"
    "  --curve            explored share and the mapper's error every 10 s and over the run, how good estimates were\n"
    "  --driving          where the time goes that driving at full speed would not take, and the distances to "
    "obstacles\n"
    "  --decisions        the time that the explorer takes for a decision: median, 99th percentile and longest\n"
    "  --log              every transition of the explorer, end of a goal and contact\n"
    "  --twice            run each seed twice and compare the hashes\n"
    "  --svg DIRECTORY    draw each trajectory over the map it made\n"
    "  --omniscient       beside each distance, that of a tour which knows the world; takes seconds to minutes a "
    "world\n"
    "Exit status 0: every run ended DONE with no reachable frontier left (or at --until) and without contact.\n"
    "Example:\n"
    "  explore_bench --seeds 1-5 --svg /tmp/tracks config/worlds/*.yaml\n";

}  // namespace frontier_pilot::bench

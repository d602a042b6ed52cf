"""A run that is recorded while the system is attacked has to give a report."""
import glob
import os
import subprocess

from run_attack import environment

ARGUMENTS = ('record:=true',)  # of the launch
REPORT = str(environment.ROOT / 'scripts' / 'report')
PATIENCE = 240.0  # [s] for the report of a long run
LEAST = 20000  # [bytes] of a page with a map and its plots


def judge(folder, outcome):
    """Makes the report of the run in `folder`, which is HOME, once the launch has ended. [FLT-1]"""
    page = os.path.join(folder, 'report.html')
    bags = glob.glob(os.path.join(os.environ['ROS_HOME'], 'frontier_pilot/runs/*/*.bag*'))
    if not outcome.expect(bags, 'nothing was recorded'):
        return
    try:
        made = subprocess.run([REPORT, 'latest', '--out', page], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        outcome.expect(False, 'the report takes longer than %.0f s' % PATIENCE)
        return
    said = made.stdout.decode(errors='replace').strip()[-300:]
    size = os.path.getsize(page) if os.path.exists(page) else 0
    outcome.expect(made.returncode == 0 and size >= LEAST, 'no report of the recorded run: exit code %d, %s' % (made.returncode, said))
    outcome.figure('a report of %.1f MB was made of %.1f MB of records' % (size / 1e6, sum(map(os.path.getsize, bags)) / 1e6))

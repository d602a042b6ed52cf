"""rviz's configuration for several robots: what they have in common, and for each robot its displays in its colour."""
import colorsys
import math

import yaml

PICTURE = 890, 700  # of rviz's window in its file, without panels [pixels]


def colour_of(index, count):
    """As rviz writes it: red, green and blue from 0 to 255."""
    return '; '.join(str(round(255 * part)) for part in colorsys.hsv_to_rgb(index / count, 0.85, 0.8))


def displays_of(name, colour):
    """One robot's outline, track, plan, goal and scan, as a group."""
    def display(kind, what, topic, **settings):
        return dict({'Class': 'rviz/' + kind, 'Name': what, 'Enabled': True, 'Topic': '/%s/%s' % (name, topic),
                     'Color': colour, 'Alpha': 1, 'Unreliable': False}, **settings)
    arrow = {'Shape': 'Arrow', 'Head Length': 0.15, 'Head Radius': 0.12, 'Shaft Length': 0.3, 'Shaft Radius': 0.04}
    dot = {'Value': 'Arrow', 'Head Length': 0.01, 'Head Radius': 0.02, 'Shaft Length': 0.05, 'Shaft Radius': 0.02,
           'Color': colour, 'Alpha': 0.6}
    return {'Class': 'rviz/Group', 'Name': name, 'Enabled': True, 'Displays': [
        display('Polygon', 'Outline', 'footprint'),
        display('Odometry', 'Track', 'odom', Keep=2000, Shape=dot, **{
            'Position Tolerance': 0.1, 'Angle Tolerance': 3.0, 'Covariance': {'Value': False}}),
        display('Path', 'Plan', 'plan', **{'Line Style': 'Billboards', 'Line Width': 0.04, 'Buffer Length': 1,
                                           'Pose Style': 'None', 'Offset': {'X': 0, 'Y': 0, 'Z': 0.02}}),
        display('Pose', 'Goal', 'frontier_explorer/goal', **arrow),
        display('LaserScan', 'Scan', 'scan', Enabled=False, Style='Flat Squares', **{
            'Color Transformer': 'FlatColor', 'Position Transformer': 'XYZ', 'Size (m)': 0.04}),
        {'Class': 'rviz/Map', 'Name': 'Its view', 'Enabled': False, 'Topic': '/%s/merged_map' % name, 'Alpha': 0.7,
         'Color Scheme': 'map', 'Draw Behind': True, 'Unreliable': False, 'Use Timestamp': False},
    ]}


def view_of(world, start):
    """The view from above that shows all of the world (robot_starts.World), upright, in the frame that lies at `start`."""
    width, height = world.width * world.resolution, world.height * world.resolution
    x, y = world.origin[0] + width / 2 - start['x'], world.origin[1] + height / 2 - start['y']
    cosine, sine = math.cos(start['yaw']), math.sin(start['yaw'])
    return {'X': cosine * x + sine * y, 'Y': cosine * y - sine * x, 'Angle': -start['yaw'],
            'Scale': 0.9 * min(PICTURE[0] / width, PICTURE[1] / height)}


def write_configuration(template, path, names, view):
    """Writes rviz's file `template` with the displays of the robots `names`, and the view, to `path`."""
    with open(template) as file:
        configuration = yaml.safe_load(file)
    configuration['Visualization Manager']['Views']['Current'].update(view)
    displays = configuration['Visualization Manager']['Displays']
    displays += [displays_of(name, colour_of(i, len(names))) for i, name in enumerate(names)]
    with open(path, 'w') as file:
        yaml.safe_dump(configuration, file, sort_keys=False)

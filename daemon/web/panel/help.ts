// One sentence for each word that the page shows, in the sense of daemon/GLOSSARY.md.

export const kHelp = {
  position: 'Where the reference point is, the centre of the tracks’ footprint: x ahead of the origin, y to the left',
  yaw: 'Direction of the robot, 0 along x, positive to the left',
  pitch: 'Inclination of the robot, positive when its nose is up',
  'cross-track error': 'Distance from the path, positive to the left of it',
  'heading error': 'Desired yaw minus yaw',
  'track speed': 'Speed of the left and of the right track, as their encoders measure it',
  'slip ratio': 'Share of a track’s speed that does not become ground speed; unknown at standstill',
  age: 'How old the values are: now minus the time at which they were measured',
  battery: 'Voltage of the battery, as the robot measures it',
  fence: 'The part of the floor that the reference point may not leave',
  plan: 'The path of the course',
  model: 'Pose by the counts of the encoders alone',
  odometry: 'Pose by encoders and gyro',
  fused: 'Pose by encoders, gyro and the overhead camera',
  truth: 'The exact pose of the emulated robot, which only an emulator knows',
  steering: 'By this estimate the robot is steered',
} as const;

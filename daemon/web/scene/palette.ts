// The colours of the page. Path, model and actual robot as in the paper's figures: planned path
// white, model red, fused pose green.
import type { EstimateName } from '../state/store.ts';

export const kPath = '#f2f5f8';
export const kEstimateColours: Record<EstimateName, string> = {
  model: '#ff5b52',
  odometry: '#4d9fff',
  fused: '#3ad07c',
  truth: '#ffd23f',
};
export const kLeft = '#58b7e8';
export const kRight = '#f0a35e';
export const kCommand = '#8d99a7';

export const kSky = '#0b1016';
export const kFloor = '#0b131d';
export const kGrid = '#212d3b';
export const kGridBold = '#34465a';
export const kFence = '#4a5868';
export const kKeepOut = '#3a1d26';
export const kObstacle = '#6b7785';
export const kObstacleEdge = '#aeb9c6';
export const kSurface = '#37506b';
export const kText = '#d7dee7';
export const kDim = '#7f8c9b';

package fieldcal.simulation.physics;

/** How the simulated ball moves. */
public enum MotionPhase {
  /** It lies still. */
  RESTING,
  /** It touches the carpet, its contact point slips. */
  SLIDING,
  /** It rolls without slip. */
  ROLLING,
  /** It does not touch the carpet. */
  FLYING
}

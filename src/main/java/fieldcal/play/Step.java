package fieldcal.play;

/** One phase of the play. A step orders what is to be done in this tick and says which step comes next. */
interface Step {

  /** What the operator sees. */
  PlayPhase phase();

  /** The robot that is to kick, 0 or 1; -1 when undecided. */
  default int kicker() {
    return -1;
  }

  /** The step of the next tick: itself to stay. Called only while both robots are seen. */
  Step tick(Situation s);

  /** The step of the next tick while no robot may drive: the ball of a kick is still watched. Robots may be out of sight. */
  default Step watch(Situation s) {
    return this;
  }

  /** Whether the ball may be on its way, so that it is watched whatever else happens. */
  default boolean isUnderWay() {
    return false;
  }
}

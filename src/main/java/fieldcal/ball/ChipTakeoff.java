package fieldcal.ball;

/**
 * The ball when a flight begins, or, after the last impact, when the rolling begins; with the derivatives that the
 * sensitivities of a chip need. Lengths are per unit of kick speed over the ground, since flights scale with it; times are
 * since the kick.
 *
 * @param time time of the takeoff, s
 * @param timeByVz derivative of the time by the kick's vertical velocity, s²/m
 * @param timeByDampingZ derivative of the time by dampingZ, s
 * @param reach distance over the ground, per kick speed, s
 * @param reachByVz derivative of the reach
 * @param reachByFirst derivative of the reach by dampingXyFirstHop
 * @param reachByOther derivative of the reach by dampingXyOtherHops
 * @param reachByDampingZ derivative of the reach by dampingZ
 * @param pace speed over the ground, per kick speed
 * @param paceByFirst derivative of the pace by dampingXyFirstHop
 * @param paceByOther derivative of the pace by dampingXyOtherHops
 * @param lift vertical velocity, per that of the kick
 * @param liftByDampingZ derivative of the lift by dampingZ
 */
record ChipTakeoff(
    double time,
    double timeByVz,
    double timeByDampingZ,
    double reach,
    double reachByVz,
    double reachByFirst,
    double reachByOther,
    double reachByDampingZ,
    double pace,
    double paceByFirst,
    double paceByOther,
    double lift,
    double liftByDampingZ) {

  /** The kick itself. */
  static final ChipTakeoff KICK = new ChipTakeoff(0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0);

  /**
   * The takeoff after the flight that begins with this one.
   *
   * @param model the model
   * @param vz the kick's vertical velocity, m/s
   * @param impact which impact ends the flight, 1 = the first
   */
  ChipTakeoff next(ChipModel model, double vz, int impact) {
    double durationByVz = 2 / Gravity.ACCELERATION * lift;
    double duration = durationByVz * vz;
    double durationByDampingZ = 2 / Gravity.ACCELERATION * vz * liftByDampingZ;
    double damping = model.dampingXyAtImpact(impact);
    return new ChipTakeoff(
        time + duration,
        timeByVz + durationByVz,
        timeByDampingZ + durationByDampingZ,
        reach + pace * duration,
        reachByVz + pace * durationByVz,
        reachByFirst + paceByFirst * duration,
        reachByOther + paceByOther * duration,
        reachByDampingZ + pace * durationByDampingZ,
        pace * damping,
        paceByFirst * damping + (impact == 1 ? pace : 0),
        paceByOther * damping + (impact == 1 ? 0 : pace),
        lift * model.dampingZ(),
        liftByDampingZ * model.dampingZ() + lift);
  }
}

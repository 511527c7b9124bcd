package fieldcal.simulation.physics;

/**
 * The equations of motion. A step of the integrator is one phase under one friction: {@link #enterStep} fixes both.
 */
final class Forces {
  private static final double G = BallPhysics.GRAVITY;

  /** What is left of a rolling ball's deceleration at least, whatever laws add, so that it stops (chosen). */
  private static final double LEAST_BRAKING = 0.05;

  private final GroundLaw ground;
  private final double radius;
  private final double beta;
  private final double slidingBeta;
  private final double dragFactor;
  private final double liftFactor;
  private final double spinDecay;
  private final double windX;
  private final double windY;
  private final ExtraLaw[] extras;
  private final Seam[] seams;
  private final boolean[] beyond;
  private final BallMoment moment = new BallMoment();
  private final double[] push = new double[2];
  private final double[] air = new double[2];

  private MotionPhase phase = MotionPhase.RESTING;
  private double stepTime;
  private double launchTime;
  private double startX;
  private double startY;
  private double startPath;
  private double launchX;
  private double launchY;
  private int hop = 1;
  private boolean worn;
  private double wear = 1;
  private boolean frozen;
  private double frozenX;
  private double frozenY;

  // External acceleration (everything but weight and carpet), and the pressure on the carpet over
  // the weight.
  private double externalX;
  private double externalY;
  private double externalZ;

  Forces(BallPhysics physics) {
    ground = physics.ground();
    radius = physics.ball().radius();
    beta = physics.ball().inertiaFactor();
    slidingBeta = physics.ball().slidingInertiaFactor();
    AirLaw air = physics.air();
    double pressure = 0.5 * air.density() * Math.PI * radius * radius / physics.ball().mass();
    dragFactor = pressure * air.dragCoefficient();
    liftFactor = pressure * radius * air.liftCoefficient();
    spinDecay = air.spinDecay();
    windX = air.windX();
    windY = air.windY();
    extras = physics.extras().toArray(new ExtraLaw[0]);
    seams = physics.seams().toArray(new Seam[0]);
    beyond = new boolean[seams.length];
  }

  /** Fixes phase, session time and friction for the coming step. */
  void enterStep(BallBody ball, double time) {
    phase = ball.phase();
    stepTime = time;
    launchTime = ball.launchTime(time);
    startX = ball.state[0];
    startY = ball.state[1];
    startPath = ball.path();
    launchX = ball.launchX();
    launchY = ball.launchY();
    hop = ball.impacts() + 1;
    for (int i = 0; i < seams.length; i++) {
      beyond[i] = seams[i].beyond(startX, startY);
    }
    frozen = false;
    worn = ground.wornAt(ball.state[0], ball.state[1]);
    wear = worn ? 1 + ground.wornChange() : 1;
  }

  /** Friction acts against this direction until the step ends. */
  void freezeDirection(double x, double y) {
    frozen = true;
    frozenX = x;
    frozenY = y;
  }

  /** Whether a state is on the same side of all edges and seams as the step's start. */
  boolean sameRegion(double[] s) {
    for (int i = 0; i < seams.length; i++) {
      if (seams[i].beyond(s[0], s[1]) != beyond[i]) {
        return false;
      }
    }
    return ground.wornAt(s[0], s[1]) == worn;
  }

  /** The seam between a state and the step's start; null when there is none. */
  Seam crossed(double[] s) {
    for (int i = 0; i < seams.length; i++) {
      if (seams[i].beyond(s[0], s[1]) != beyond[i]) {
        return seams[i];
      }
    }
    return null;
  }

  /** What {@link ExtraLaw}s may know of a state. */
  BallMoment moment(double offset, double[] s) {
    moment.x = s[0];
    moment.y = s[1];
    moment.vx = s[3];
    moment.vy = s[4];
    moment.vz = s[5];
    boolean slides = phase == MotionPhase.SLIDING;
    moment.slipX = slides ? slipX(s) : 0;
    moment.slipY = slides ? slipY(s) : 0;
    moment.slip = Math.hypot(moment.slipX, moment.slipY);
    moment.sessionTime = stepTime + offset;
    moment.sinceKick = moment.sessionTime - launchTime;
    moment.path =
        phase == MotionPhase.FLYING
            ? startPath
            : startPath + Math.hypot(s[0] - startX, s[1] - startY);
    moment.distance = Math.hypot(s[0] - launchX, s[1] - launchY);
    moment.hop = hop;
    return moment;
  }

  private double extraSliding() {
    double factor = 1;
    for (ExtraLaw law : extras) {
      factor *= Math.max(0, law.slidingFactor(moment));
    }
    return factor;
  }

  private double extraAcross() {
    double across = 0;
    for (ExtraLaw law : extras) {
      across += law.slidingAcross(moment);
    }
    return across;
  }

  private double extraRolling() {
    double factor = 1;
    double sum = 1;
    for (ExtraLaw law : extras) {
      factor *= Math.max(0, law.rollingFactor(moment));
      sum += law.rollingChange(moment);
    }
    return factor * Math.max(0, sum);
  }

  private double extraTurning() {
    double part = 0;
    for (ExtraLaw law : extras) {
      part += law.resistedTurning(moment);
    }
    return part;
  }

  /** Factor on e_z of an impact of the moment that was asked for last. */
  double extraRestitution() {
    double factor = 1;
    for (ExtraLaw law : extras) {
      factor *= law.restitutionFactor(moment);
    }
    return factor;
  }

  /** Factor on the velocity along the carpet after an impact of the moment that was asked for last. */
  double extraAlong() {
    double factor = 1;
    for (ExtraLaw law : extras) {
      factor *= law.alongFactor(moment);
    }
    return factor;
  }

  /** Added to e_z of an impact of the moment that was asked for last. */
  double addedRestitution() {
    double sum = 0;
    for (ExtraLaw law : extras) {
      sum += law.restitutionChange(moment);
    }
    return sum;
  }

  /** Added to the fraction of the velocity along the carpet that an impact of the moment that was asked for last leaves. */
  double addedAlong() {
    double sum = 0;
    for (ExtraLaw law : extras) {
      sum += law.alongChange(moment);
    }
    return sum;
  }

  /** By how much an impact of the moment that was asked for last turns the path, rad. */
  double turn() {
    double sum = 0;
    for (ExtraLaw law : extras) {
      sum += law.turn(moment);
    }
    return sum;
  }

  /** Adds what laws add along and across the path, along at most this much, m/s². */
  private void addToPath(double[] s, double most, double[] rate) {
    double speed = Math.sqrt(s[3] * s[3] + s[4] * s[4]);
    if (extras.length == 0 || speed == 0) {
      return;
    }
    double along = 0;
    double across = 0;
    for (ExtraLaw law : extras) {
      along += law.alongPath(moment);
      across += law.acrossPath(moment);
    }
    along = Math.min(most, along);
    rate[3] += (along * s[3] - across * s[4]) / speed;
    rate[4] += (along * s[4] + across * s[3]) / speed;
  }

  double spinDecay() {
    return spinDecay;
  }

  double radius() {
    return radius;
  }

  double slidingInertiaFactor() {
    return slidingBeta;
  }

  double inertiaFactor() {
    return beta;
  }

  /** Slip of the contact point: v + ω × (0, 0, −r); of a derivative, its rate of change. */
  double slipX(double[] s) {
    return s[3] - radius * s[7];
  }

  double slipY(double[] s) {
    return s[4] + radius * s[6];
  }

  void makeRolling(double[] s) {
    s[6] = -s[4] / radius;
    s[7] = s[3] / radius;
  }

  /** Spin about the rolling axis over rolling spin; 0 at standstill. */
  double spinFraction(double[] s) {
    double squared = s[3] * s[3] + s[4] * s[4];
    return squared == 0 ? 0 : radius * (s[7] * s[3] - s[6] * s[4]) / squared;
  }

  /** Turns the ball as a horizontal push at the contact point does that changes its velocity by the given amount. */
  void addSpinOfImpulse(double[] s, double changeX, double changeY) {
    s[6] += changeY / (beta * radius);
    s[7] -= changeX / (beta * radius);
  }

  /** Whether a ball at rest stays at rest under the forces of the last call of {@link #derivative}. */
  boolean holds() {
    double push = Math.hypot(externalX, externalY) / (1 + beta);
    return push
        <= wear
            * extraRolling()
            * ground.rollingDecelerationAt(externalX * 1e-9, externalY * 1e-9, stepTime);
  }

  /** Rate of change of position, velocity and spin, {@code offset} seconds after the step's start. */
  void derivative(double offset, double[] s, double[] rate) {
    rate[0] = s[3];
    rate[1] = s[4];
    rate[2] = s[5];
    if (extras.length > 0) {
      moment(offset, s);
    }
    external(s);
    switch (phase) {
      case FLYING -> fly(s, rate);
      case SLIDING -> slide(offset, s, rate);
      default -> roll(offset, s, rate);
    }
  }

  private void external(double[] s) {
    air[0] = windX;
    air[1] = windY;
    for (ExtraLaw law : extras) {
      law.flow(moment, air);
    }
    double x = s[3] - air[0];
    double y = s[4] - air[1];
    double drag = dragFactor * Math.sqrt(x * x + y * y + s[5] * s[5]);
    externalX = liftFactor * (s[7] * s[5] - s[8] * s[4]) - drag * x + G * ground.slopeX();
    externalY = liftFactor * (s[8] * s[3] - s[6] * s[5]) - drag * y + G * ground.slopeY();
    externalZ = liftFactor * (s[6] * s[4] - s[7] * s[3]) - drag * s[5];
    for (ExtraLaw law : extras) {
      push[0] = 0;
      push[1] = 0;
      law.push(moment, push);
      externalX += push[0];
      externalY += push[1];
    }
  }

  private void fly(double[] s, double[] rate) {
    rate[3] = externalX;
    rate[4] = externalY;
    rate[5] = externalZ - G;
    for (int i = 6; i < 9; i++) {
      rate[i] = -spinDecay * s[i];
    }
  }

  private void slide(double offset, double[] s, double[] rate) {
    double directionX = frozenX;
    double directionY = frozenY;
    double slipX = slipX(s);
    double slipY = slipY(s);
    double slip = Math.sqrt(slipX * slipX + slipY * slipY);
    if (!frozen) {
      directionX = slip == 0 ? 0 : slipX / slip;
      directionY = slip == 0 ? 0 : slipY / slip;
    }
    double plain =
        ground.slidingFriction() * ground.slipFactor(slip) * wear * Math.max(0, G - externalZ);
    double friction = plain * extraSliding();
    double across = plain * extraAcross();
    double frictionX = -friction * directionX - across * directionY;
    double frictionY = -friction * directionY + across * directionX;
    rate[3] = frictionX + externalX;
    rate[4] = frictionY + externalY;
    addToPath(s, friction, rate);
    rate[5] = 0;
    rate[6] = frictionY / (slidingBeta * radius);
    rate[7] = -frictionX / (slidingBeta * radius);
    rate[8] = -ground.verticalSpinDecay() * s[8];
    double resisted = extraTurning();
    if (resisted != 0) {
      resistTurning(resisted * rollingDeceleration(offset, s), directionX, directionY, s, rate);
    }
  }

  /** The torque that brakes a rolling ball by that deceleration opposes the spin; a ball that does not turn yet begins to turn as friction along the slip makes it. */
  private void resistTurning(
      double deceleration, double slipX, double slipY, double[] s, double[] rate) {
    double spin = Math.hypot(s[6], s[7]);
    double x = spin == 0 ? slipX : s[7] / spin;
    double y = spin == 0 ? slipY : -s[6] / spin;
    double perRadius = (1 + beta) / beta * deceleration / radius;
    rate[6] += perRadius * y;
    rate[7] -= perRadius * x;
  }

  private double rollingDeceleration(double offset, double[] s) {
    return wear
        * ground.waveAt(s[0])
        * extraRolling()
        * Math.max(0, 1 - externalZ / G)
        * ground.rollingDecelerationAt(s[3], s[4], stepTime + offset);
  }

  private void roll(double offset, double[] s, double[] rate) {
    double directionX = frozenX;
    double directionY = frozenY;
    if (!frozen) {
      // A ball that starts to roll from rest starts downhill.
      boolean moves = s[3] != 0 || s[4] != 0;
      double alongX = moves ? s[3] : externalX;
      double alongY = moves ? s[4] : externalY;
      double length = Math.sqrt(alongX * alongX + alongY * alongY);
      directionX = length == 0 ? 0 : alongX / length;
      directionY = length == 0 ? 0 : alongY / length;
    }
    double deceleration = rollingDeceleration(offset, s);
    rate[3] = -deceleration * directionX + externalX / (1 + beta);
    rate[4] = -deceleration * directionY + externalY / (1 + beta);
    addToPath(s, (1 - LEAST_BRAKING) * deceleration, rate);
    rate[5] = 0;
    rate[6] = -rate[4] / radius;
    rate[7] = rate[3] / radius;
    rate[8] = -ground.verticalSpinDecay() * s[8];
  }
}

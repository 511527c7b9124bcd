package fieldcal.simulation.physics;

/** The classical Runge–Kutta step of fourth order, without allocation. */
final class RungeKutta {
  private final Forces forces;
  private final double[] k1 = new double[9];
  private final double[] k2 = new double[9];
  private final double[] k3 = new double[9];
  private final double[] k4 = new double[9];
  private final double[] at = new double[9];

  RungeKutta(Forces forces) {
    this.forces = forces;
  }

  /** Result = state one step later; the two may not be the same array. */
  void step(double[] state, double step, double[] result) {
    forces.derivative(0, state, k1);
    move(state, k1, 0.5 * step);
    forces.derivative(0.5 * step, at, k2);
    move(state, k2, 0.5 * step);
    forces.derivative(0.5 * step, at, k3);
    move(state, k3, step);
    forces.derivative(step, at, k4);
    for (int i = 0; i < result.length; i++) {
      result[i] = state[i] + step / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
    }
  }

  private void move(double[] state, double[] rate, double by) {
    for (int i = 0; i < at.length; i++) {
      at[i] = state[i] + by * rate[i];
    }
  }
}

package fieldcal.simulation.physics;

/**
 * The ball's recent path, for cameras, which look at it a little later: they expose at their own times, which do not coincide with integration steps. Between
 * two nodes position is a cubic of both ends' positions and velocities, exact to far below a micrometre at steps of 1 ms. Not thread-safe.
 */
public final class BallHistory implements BallTrace {
  private static final int FIELDS = 8;

  private double[] nodes = new double[FIELDS * 1024];
  private int first;
  private int end;

  /** An empty history. */
  public BallHistory() {}

  @Override
  public void node(double time, BallBody ball) {
    add(time, ball, true);
  }

  @Override
  public void event(BallEvent event) {}

  /**
   * A node while nobody can see the ball, for example because it is being carried.
   *
   * @param time session time, s
   * @param ball the ball
   */
  public void hiddenNode(double time, BallBody ball) {
    add(time, ball, false);
  }

  private void add(double time, BallBody ball, boolean visible) {
    if (end + FIELDS > nodes.length) {
      makeRoom();
    }
    nodes[end] = time;
    System.arraycopy(ball.state, 0, nodes, end + 1, 6);
    nodes[end + 7] = visible ? 1 : 0;
    end += FIELDS;
  }

  private void makeRoom() {
    int used = end - first;
    double[] target = used > nodes.length / 2 ? new double[2 * nodes.length] : nodes;
    System.arraycopy(nodes, first, target, 0, used);
    nodes = target;
    first = 0;
    end = used;
  }

  /**
   * Forgets what lies further back; the last node at or before the time stays.
   *
   * @param time session time, s
   */
  public void forgetBefore(double time) {
    while (first + FIELDS < end && nodes[first + FIELDS] <= time) {
      first += FIELDS;
    }
  }

  /**
   * Position at a time within the history.
   *
   * @param time session time, s
   * @param xyz gets the position, m (z = height of the lowest point)
   * @return whether the ball could be seen then; false also outside the history
   */
  public boolean positionAt(double time, double[] xyz) {
    int low = 0;
    int high = (end - first) / FIELDS - 1;
    if (high < 0 || time < nodes[first] || time > nodes[end - FIELDS]) {
      return false;
    }
    // The last node at or before the time.
    while (low < high) {
      int middle = (low + high + 1) / 2;
      if (nodes[first + middle * FIELDS] <= time) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    int a = first + low * FIELDS;
    int b = Math.min(a + FIELDS, end - FIELDS);
    double span = nodes[b] - nodes[a];
    if (span <= 0) {
      System.arraycopy(nodes, a + 1, xyz, 0, 3);
      return nodes[a + 7] != 0;
    }
    double s = (time - nodes[a]) / span;
    double r = 1 - s;
    double fromA = r * r * (1 + 2 * s);
    double fromB = s * s * (3 - 2 * s);
    double slopeA = r * r * s * span;
    double slopeB = -s * s * r * span;
    for (int i = 1; i <= 3; i++) {
      xyz[i - 1] =
          fromA * nodes[a + i]
              + fromB * nodes[b + i]
              + slopeA * nodes[a + 3 + i]
              + slopeB * nodes[b + 3 + i];
    }
    return nodes[a + 7] != 0 && nodes[b + 7] != 0;
  }
}

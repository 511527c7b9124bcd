package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.Parameter;
import fieldcal.fit.joint.KickTerm;
import fieldcal.fit.joint.Probe;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * One kick under the closed forms, as a term of the kernel. Per-kick parameters: position x, y (m), velocity vx, vy, for chips vz (m/s), time (s); then by how much the bounces of a chip differ from each other, if they may; then the kick's values of those model parameters that differ from kick to kick. A chip's number of flights is the discrete unknown. Derivatives are exact, except that their change with the small differences between the bounces is neglected. Immutable.
 *
 * <p>The state of the global model: accSlide, accRoll, kSwitch of flat kicks, the four parameters of chips, then the offset x, y (m) of each camera.
 */
final class FlightTerm implements KickTerm<double[]> {
  /** Where the parameters of chips begin in the state. */
  static final int CHIP = 3;

  /** Where the cameras' offsets begin in the state. */
  static final int OFFSETS = 7;

  /** A number of flights may differ from the 10 mm rule's by so many, since a real ball does not stop hopping at exactly that height. */
  private static final int OFF_RULE = 1;

  /** Prefix of the names of the parameters that say by how much bounces differ from each other. */
  private static final String BOUNCES = "difference between bounces ";

  /** Their scale: that of the dampings. */
  private static final double BOUNCE_SCALE = 0.1;

  private final KickFit fit;
  private final FlightData data;
  private final int[] slot;
  private final int[] used;
  private final int flights;

  /** For each unknown of the trajectory, its index in the per-kick parameters; negative where it is in the state. */
  private final int[] index;

  private final List<Parameter> own;

  private FlightTerm(
      KickFit fit,
      FlightData data,
      int[] slot,
      int[] used,
      int flights,
      int[] index,
      List<Parameter> own) {
    this.fit = fit;
    this.data = data;
    this.slot = slot;
    this.used = used;
    this.flights = flights;
    this.index = index;
    this.own = own;
  }

  /**
   * A fitted kick, with the detections and the number of flights of its own fit.
   *
   * @param slot which of the state's cameras made each observation
   * @param globals parameters of both models, in the state's order
   * @param scattering indices of those that differ from kick to kick, in the order of the problem's random effects
   */
  static FlightTerm of(
      KickFit fit, FlightData data, int[] slot, List<Parameter> globals, int[] scattering) {
    int kick = FlightLayout.kickSize(fit.kind());
    int first = fit.kind() == KickKind.FLAT ? 0 : CHIP;
    int[] index = new int[FlightLayout.size(fit.kind())];
    List<Parameter> own = new ArrayList<>();
    for (int k = 0; k < kick; k++) {
      own.add(fit.estimates().get(k).parameter());
      index[k] = k;
    }
    Arrays.fill(index, kick, index.length, -1);
    UnevenBounces bounces = fit.bounces();
    for (int k = 0; k < bounces.size(); k++) {
      own.add(new Parameter(BOUNCES + (k + 1), "", 0, BOUNCE_SCALE, -1, 1, true, "starts at none"));
    }
    int random = own.size();
    for (int r = 0; r < scattering.length; r++) {
      int k = kick + scattering[r] - first;
      boolean ofThisKind = k >= kick && k < index.length;
      Parameter p = globals.get(scattering[r]);
      own.add(ofThisKind ? p.withValue(p.clamp(fit.estimates().get(k).value())) : p);
      if (ofThisKind) {
        index[k] = random + r;
      }
    }
    int[] used = IntStream.range(0, data.size).filter(fit::used).toArray();
    return new FlightTerm(
        fit, data, slot, used, fit.statistics().flights(), index, List.copyOf(own));
  }

  private FlightTerm withFlights(int other) {
    return new FlightTerm(fit, data, slot, used, other, index, own);
  }

  /** The same term with the outliers at the given parameters left out; this term itself when they are the same as before. */
  FlightTerm screened(double[] ownValues, double[] state, double outlierDistance) {
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    plainResiduals(ownValues, state, rx, ry);
    Screening screening = Screening.of(data, rx, ry, outlierDistance);
    int[] kept = IntStream.range(0, data.size).filter(screening::kept).toArray();
    return Arrays.equals(kept, used)
        ? this
        : new FlightTerm(fit, data, slot, kept, flights, index, own);
  }

  KickKind kind() {
    return fit.kind();
  }

  /** All detections, used or not. */
  int observations() {
    return data.size;
  }

  /** The start of the per-kick parameters: where the kick's own fit ended; for those that it does not have, where the joint fit begins. */
  double[] start() {
    return own.stream().mapToDouble(Parameter::value).toArray();
  }

  @Override
  public int ownSize() {
    return own.size();
  }

  @Override
  public int rows() {
    return 2 * used.length;
  }

  /** The unknowns in the order of the trajectory's sensitivities. */
  private double[] theta(double[] ownValues, double[] state) {
    double[] theta = new double[index.length];
    for (int k = 0; k < theta.length; k++) {
      theta[k] = index[k] >= 0 ? ownValues[index[k]] : state[inState(k)];
    }
    return theta;
  }

  /** Index in the state of a parameter of the model. */
  private int inState(int unknown) {
    return unknown - FlightLayout.kickSize(kind()) + (kind() == KickKind.FLAT ? 0 : CHIP);
  }

  private FlightCurve curve(double[] theta) {
    FlightCurve curve = FlightCurve.of(kind(), flights, fit.kick().fromRest());
    curve.set(theta);
    return curve;
  }

  /** Where the ball is under one set of unknowns, with bounces that differ from each other as the per-kick parameters say. */
  private final class Path {
    final FlightCurve curve;
    private final double[] deviations;

    /** Derivatives of the distance with respect to the damping at each impact, at the last position that was asked for, m. */
    final double[] byImpact = new double[flights];

    final double ux;
    final double uy;

    Path(double[] ownValues, double[] state) {
      double[] theta = theta(ownValues, state);
      curve = curve(theta);
      int first = FlightLayout.kickSize(kind());
      deviations =
          fit.bounces()
              .deviations(Arrays.copyOfRange(ownValues, first, first + fit.bounces().size()));
      double speed = Math.hypot(theta[ChipTrajectory.VX0], theta[ChipTrajectory.VY0]);
      ux = speed > 0 ? theta[ChipTrajectory.VX0] / speed : 0;
      uy = speed > 0 ? theta[ChipTrajectory.VY0] / speed : 0;
    }

    void position(double time, double[] xyz) {
      curve.position(time, xyz);
      if (deviations.length > 0) {
        curve.byImpact(time, byImpact);
        double longer = UnevenBounces.longer(deviations, byImpact);
        xyz[0] += longer * ux;
        xyz[1] += longer * uy;
      }
    }
  }

  @Override
  public void residuals(double[] ownValues, double[] state, double[] out) {
    Path path = new Path(ownValues, state);
    double[] xyz = new double[3];
    for (int n = 0; n < used.length; n++) {
      int i = used[n];
      path.position(data.time[i], xyz);
      double stretch = data.stretch(i, xyz[2]);
      double rx = data.residualX(i, xyz, stretch) - state[OFFSETS + 2 * slot[i]];
      double ry = data.residualY(i, xyz, stretch) - state[OFFSETS + 2 * slot[i] + 1];
      out[2 * n] = data.w11[i] * rx;
      out[2 * n + 1] = data.w21[i] * rx + data.w22[i] * ry;
    }
  }

  /** Seen minus predicted position in the ground plane, m, of all detections, used or not. */
  void plainResiduals(double[] ownValues, double[] state, double[] rx, double[] ry) {
    Path path = new Path(ownValues, state);
    double[] xyz = new double[3];
    for (int i = 0; i < data.size; i++) {
      path.position(data.time[i], xyz);
      double stretch = data.stretch(i, xyz[2]);
      rx[i] = data.residualX(i, xyz, stretch) - state[OFFSETS + 2 * slot[i]];
      ry[i] = data.residualY(i, xyz, stretch) - state[OFFSETS + 2 * slot[i] + 1];
    }
  }

  /** Sum of the squared residuals per axis of the detections that are used, m². */
  double squaredResiduals(double[] ownValues, double[] state) {
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    plainResiduals(ownValues, state, rx, ry);
    double sum = 0;
    for (int i : used) {
      sum += rx[i] * rx[i] + ry[i] * ry[i];
    }
    return sum;
  }

  @Override
  public void ownColumns(
      double[] ownValues, double[] state, double[] residuals, double[][] columns) {
    double[][] directions = new double[own.size()][index.length];
    for (int k = 0; k < index.length; k++) {
      if (index[k] >= 0) {
        directions[index[k]][k] = 1;
      }
    }
    along(directions, new double[own.size()][], ownValues, state, columns);
    if (fit.bounces().size() > 0) {
      bounceColumns(new Path(ownValues, state), columns);
    }
  }

  private void bounceColumns(Path path, double[][] columns) {
    int first = FlightLayout.kickSize(kind());
    double[] xyz = new double[3];
    for (int n = 0; n < used.length; n++) {
      int i = used[n];
      path.position(data.time[i], xyz);
      double stretch = data.stretch(i, xyz[2]);
      for (int k = 0; k < fit.bounces().size(); k++) {
        double longer = stretch * fit.bounces().along(k, path.byImpact);
        double gx = longer * path.ux;
        double gy = longer * path.uy;
        columns[first + k][2 * n] = data.w11[i] * gx;
        columns[first + k][2 * n + 1] = data.w21[i] * gx + data.w22[i] * gy;
      }
    }
  }

  @Override
  public void sharedColumns(
      double[] ownValues,
      double[] state,
      double[] residuals,
      List<Probe<double[]>> probes,
      double[][] columns) {
    double[][] directions = new double[columns.length][index.length];
    double[][] offsets = new double[columns.length][state.length - OFFSETS];
    for (int c = 0; c < columns.length; c++) {
      Probe<double[]> probe = probes.get(c);
      double[] from = probe.from() == null ? state : probe.from();
      double[] to = probe.to();
      for (int k = 0; k < index.length; k++) {
        if (index[k] < 0) {
          directions[c][k] = (to[inState(k)] - from[inState(k)]) / probe.width();
        }
      }
      for (int k = 0; k < offsets[c].length; k++) {
        offsets[c][k] = (to[OFFSETS + k] - from[OFFSETS + k]) / probe.width();
      }
    }
    along(directions, offsets, ownValues, state, columns);
  }

  /** Whitened derivatives of the prediction along directions of the trajectory's unknowns and of the offsets. */
  private void along(
      double[][] directions,
      double[][] offsets,
      double[] ownValues,
      double[] state,
      double[][] columns) {
    double[] theta = theta(ownValues, state);
    FlightCurve curve = curve(theta);
    double[] xyz = new double[3];
    double[] dx = new double[theta.length];
    double[] dy = new double[theta.length];
    double[] dz = new double[theta.length];
    int[][] moved = new int[directions.length][];
    for (int c = 0; c < moved.length; c++) {
      double[] direction = directions[c];
      moved[c] = IntStream.range(0, theta.length).filter(k -> direction[k] != 0).toArray();
    }
    for (int n = 0; n < used.length; n++) {
      int i = used[n];
      curve.sensitivities(data.time[i], xyz, dx, dy, dz);
      double h = data.cameraHeight[i];
      double f = h / (h - xyz[2]);
      double fz = f * f / h;
      double px = xyz[0] - data.cameraX[i];
      double py = xyz[1] - data.cameraY[i];
      for (int c = 0; c < columns.length; c++) {
        double gx = 0;
        double gy = 0;
        for (int k : moved[c]) {
          gx += directions[c][k] * (f * dx[k] + px * fz * dz[k]);
          gy += directions[c][k] * (f * dy[k] + py * fz * dz[k]);
        }
        if (offsets[c] != null) {
          gx += offsets[c][2 * slot[i]];
          gy += offsets[c][2 * slot[i] + 1];
        }
        columns[c][2 * n] = data.w11[i] * gx;
        columns[c][2 * n + 1] = data.w21[i] * gx + data.w22[i] * gy;
      }
    }
  }

  private boolean isBounce(int index) {
    int first = FlightLayout.kickSize(kind());
    return index >= first && index < first + fit.bounces().size();
  }

  @Override
  public double ownPrior(int index) {
    return isBounce(index) ? 0 : fit.kick().time();
  }

  /** Without rest before the kick, its time is known only from where two lines cross. */
  @Override
  public double ownPrecision(int index) {
    if (isBounce(index)) {
      return fit.bounces().precision();
    }
    boolean tied = index == FlightLayout.timeIndex(kind()) && !fit.kick().fromRest();
    return tied ? 1 / (fit.kick().timeError() * fit.kick().timeError()) : 0;
  }

  @Override
  public void clamp(double[] ownValues) {
    for (int k = 0; k < ownValues.length; k++) {
      // A step that is not a number leads back to the start.
      Parameter p = own.get(k);
      ownValues[k] = Double.isNaN(ownValues[k]) ? p.value() : p.clamp(ownValues[k]);
    }
  }

  @Override
  public List<KickTerm<double[]>> neighbours() {
    List<KickTerm<double[]>> others = new ArrayList<>();
    if (kind() == KickKind.CHIP && flights > 1) {
      others.add(withFlights(flights - 1));
    }
    if (kind() == KickKind.CHIP && flights < ChipModel.MAX_FLIGHTS) {
      others.add(withFlights(flights + 1));
    }
    return others;
  }

  @Override
  public double penalty(double[] ownValues, double[] state) {
    if (kind() == KickKind.FLAT) {
      return 0;
    }
    double[] theta = theta(ownValues, state);
    int byRule =
        ChipTrajectory.flightsByRule(FlightLayout.chipModel(theta), theta[ChipTrajectory.VZ0]);
    return Math.abs(byRule - flights) <= OFF_RULE
        ? FlightLayout.rulePenalty(theta, flights)
        : Double.POSITIVE_INFINITY;
  }
}

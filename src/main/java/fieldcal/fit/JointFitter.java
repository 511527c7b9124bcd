package fieldcal.fit;

import fieldcal.ball.Parameter;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Fits all kicks at once: one model, one offset per camera, and position, velocity and time of each kick.
 *
 * <p>Uses what partial kicks know, each observation with its weight. Levenberg–Marquardt on normal equations from which the
 * unknowns of the kicks are eliminated. The standard errors are the larger of those that follow from the residuals as independent
 * noise and those from the scatter between kicks (cluster-robust, Liang and Zeger 1986): where the model is not quite right, the
 * first are too small. Immutable and thread-safe.
 */
public final class JointFitter {
  private static final int MAX_ITERATIONS = 40;
  private static final int OUTLIER_ROUNDS = 3;

  /**
   * A step that lowers the cost by less than this share of the reduced chi-square is the last: it moves no estimate by more than a
   * tenth of its error. Less cannot be asked for, since detections that pass from one hop to the next make the cost uneven.
   */
  private static final double ENOUGH = 0.01;

  /** The offsets' mean is held at zero to that precision; otherwise all kicks could move along, m. */
  private static final double GAUGE = 1e-6;

  /** With more damping than that no step changes anything. */
  private static final double MOST_DAMPING = 1e12;

  /** Unknowns of the flat (3) and the chip model (4), before those of the cameras. */
  private static final int MODEL = 7;

  private final FitSettings settings;

  /**
   * A fitter.
   *
   * @param settings loss and outlier limits
   */
  public JointFitter(FitSettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
  }

  /**
   * Fits.
   *
   * @param problem at least one fitted kick
   * @return the joint model
   * @throws IllegalArgumentException when there is no fitted kick
   */
  public JointFit fit(JointProblem problem) {
    if (problem.fits().isEmpty()) {
      throw new IllegalArgumentException("a joint fit needs at least one kick");
    }
    return new Run(problem).fit();
  }

  /** One joint fit; used once. */
  private final class Run {
    private final JointProblem problem;
    private final List<Parameter> shared;
    private final int[] cameraIds;
    private final int[] group;
    private final int size;
    private final List<JointKick> kicks = new ArrayList<>();
    private final double[] values;
    private final boolean[] free;
    private double lambda = 1e-4;
    private int iterations;
    private boolean converged;

    Run(JointProblem problem) {
      this.problem = problem;
      cameraIds =
          problem.fits().stream()
              .flatMapToInt(f -> Arrays.stream(f.kick().observations().cameras()))
              .distinct()
              .sorted()
              .toArray();
      group = groups();
      shared = sharedParameters();
      size = shared.size();
      values = shared.stream().mapToDouble(Parameter::value).toArray();
      free = new boolean[size];
      for (int k = 0; k < size; k++) {
        free[k] = shared.get(k).estimated();
      }
      problem.fits().forEach(f -> kicks.add(jointKick(f)));
    }

    private List<Parameter> sharedParameters() {
      boolean flats = problem.fits().stream().anyMatch(f -> f.kind() == KickKind.FLAT);
      boolean chips = problem.fits().stream().anyMatch(f -> f.kind() == KickKind.CHIP);
      List<Parameter> all = new ArrayList<>();
      for (Parameter p : problem.flat().parameters()) {
        all.add(flats ? p.withValue(p.clamp(p.value())) : p.fixed());
      }
      for (Parameter p : problem.chip().parameters()) {
        boolean given = p.name().equals("accRoll") && problem.chipRoll().isPresent();
        Parameter start =
            given
                ? p.withValue(problem.chipRoll().getAsDouble()).fixed()
                : p.withValue(p.clamp(p.value()));
        all.add(chips ? start : start.fixed());
      }
      for (int id : cameraIds) {
        for (String axis : new String[] {"x", "y"}) {
          Parameter p =
              new Parameter(
                  "offset " + axis + " of camera " + id,
                  "m",
                  0,
                  0.01,
                  -1,
                  1,
                  true,
                  "starts at none");
          all.add(problem.offsets() && cameraIds.length > 1 ? p : p.fixed());
        }
      }
      return all;
    }

    private JointKick jointKick(KickFit fit) {
      boolean flat = fit.kind() == KickKind.FLAT;
      int model = flat ? 3 : 4;
      int[] map = new int[model + 2 * cameraIds.length];
      for (int k = 0; k < model; k++) {
        map[k] = (flat ? 0 : 3) + k;
      }
      for (int k = model; k < map.length; k++) {
        map[k] = MODEL + k - model;
      }
      Observations seen = fit.kick().observations();
      int[] slot = new int[seen.size()];
      for (int i = 0; i < slot.length; i++) {
        slot[i] = Arrays.binarySearch(cameraIds, seen.camera(i));
      }
      return new JointKick(
          fit, FlightData.of(seen, problem.cameras()), slot, cameraIds.length, map);
    }

    JointFit fit() {
      minimize();
      for (int round = 0; round < OUTLIER_ROUNDS; round++) {
        boolean changed = false;
        for (int k = 0; k < kicks.size(); k++) {
          kicks.get(k).leaveOutliersOut(values, settings.outlierDistance());
          changed |= kicks.get(k).tryFlights(values);
        }
        minimize();
        if (!changed && round > 0) {
          break;
        }
      }
      return result();
    }

    private void minimize() {
      double[][] a = new double[size][size];
      double[] b = new double[size];
      double cost = assemble(a, b, true);
      int observations = kicks.stream().mapToInt(JointKick::observations).sum();
      double growth = 2;
      converged = false;
      for (int i = 0; i < MAX_ITERATIONS && !converged; i++) {
        iterations++;
        double[] step = solve(a, b);
        double[] next = values.clone();
        for (int k = 0; k < size; k++) {
          next[k] = shared.get(k).clamp(values[k] + step[k]);
          step[k] = next[k] - values[k];
        }
        double nextCost = 0;
        for (JointKick kick : kicks) {
          nextCost += kick.costAfter(next, step);
        }
        if (nextCost <= cost) {
          converged = cost - nextCost < ENOUGH * cost / (2.0 * observations);
          System.arraycopy(next, 0, values, 0, size);
          kicks.forEach(JointKick::accept);
          lambda = Math.max(1e-9, lambda / 5);
          growth = 2;
          cost = assemble(a, b, true);
        } else {
          converged = nextCost - cost < 1e-10 * cost;
          if (lambda > MOST_DAMPING || Double.isNaN(nextCost)) {
            break;
          }
          lambda *= growth;
          growth *= 2;
          assemble(a, b, false);
        }
      }
    }

    private double assemble(double[][] a, double[] b, boolean evaluate) {
      for (double[] row : a) {
        Arrays.fill(row, 0);
      }
      Arrays.fill(b, 0);
      double cost = 0;
      for (JointKick kick : kicks) {
        cost += evaluate ? kick.reduce(values, lambda, a, b) : kick.reduceAgain(lambda, a, b);
      }
      gauge(a, b);
      return cost;
    }

    /** Holds the mean offset of each group of cameras that saw kicks in common at zero. */
    private void gauge(double[][] a, double[] b) {
      double weight = 1 / (GAUGE * GAUGE);
      for (int axis = 0; axis < 2; axis++) {
        for (int c = 0; c < cameraIds.length; c++) {
          double sum = 0;
          for (int d = 0; d < cameraIds.length; d++) {
            sum += group[c] == group[d] ? values[MODEL + 2 * d + axis] : 0;
            a[MODEL + 2 * c + axis][MODEL + 2 * d + axis] += group[c] == group[d] ? weight : 0;
          }
          b[MODEL + 2 * c + axis] -= weight * sum;
        }
      }
    }

    /** Cameras that saw the same kick belong together, also through others. */
    private int[] groups() {
      int[] of = new int[cameraIds.length];
      Arrays.setAll(of, c -> c);
      for (KickFit fit : problem.fits()) {
        int[] seen = fit.kick().observations().cameras();
        int first = of[Arrays.binarySearch(cameraIds, seen[0])];
        for (int id : seen) {
          int other = of[Arrays.binarySearch(cameraIds, id)];
          for (int c = 0; c < of.length; c++) {
            of[c] = of[c] == other ? first : of[c];
          }
        }
      }
      return of;
    }

    private double[] solve(double[][] a, double[] b) {
      NormalEquations n = shared(a, b);
      double[][] l = new double[size][size];
      double[] step = new double[size];
      boolean[] active = active(n);
      double damping = lambda;
      while (!n.factor(damping, scales(), active, l)) {
        damping = Math.max(1e-9, damping * 10);
        if (damping > MOST_DAMPING) {
          // Not a number somewhere: no step, and the fit ends without having converged.
          return step;
        }
      }
      n.solve(l, scales(), active, step);
      return step;
    }

    private NormalEquations shared(double[][] a, double[] b) {
      NormalEquations n = new NormalEquations(size);
      for (int i = 0; i < size; i++) {
        System.arraycopy(a[i], 0, n.a[i], 0, size);
        n.b[i] = b[i];
      }
      return n;
    }

    private boolean[] active(NormalEquations n) {
      boolean[] active = new boolean[size];
      for (int k = 0; k < size; k++) {
        active[k] = free[k] && n.a[k][k] > 0;
      }
      return active;
    }

    private double[] scales() {
      return shared.stream().mapToDouble(Parameter::scale).toArray();
    }

    private JointFit result() {
      double[][] a = new double[size][size];
      double[] b = new double[size];
      double[][] scatter = new double[size][size];
      lambda = 0;
      double chiSquare = 0;
      int own = 0;
      for (JointKick kick : kicks) {
        double[] before = b.clone();
        chiSquare += kick.reduce(values, 0, a, b);
        own += kick.own();
        for (int i = 0; i < size; i++) {
          for (int j = 0; j < size; j++) {
            scatter[i][j] += (b[i] - before[i]) * (b[j] - before[j]);
          }
        }
      }
      gauge(a, b);
      NormalEquations n = shared(a, b);
      for (int k = 0; k < MODEL; k++) {
        // What no kick determines would make the matrix singular; so it only comes out with an
        // error beyond all bounds.
        n.a[k][k] += 1 / (1e6 * shared.get(k).scale() * shared.get(k).scale());
      }
      boolean[] active = active(n);
      double[][] inverse = n.inverse(scales(), active);
      double[] all = new double[2];
      double[] flat = new double[2];
      double[] chip = new double[2];
      int total = 0;
      for (JointKick kick : kicks) {
        kick.residuals(values, all);
        kick.residuals(values, kick.kind() == KickKind.FLAT ? flat : chip);
        total += kick.observations();
      }
      int unknowns = own;
      for (boolean f : active) {
        unknowns += f ? 1 : 0;
      }
      double reduced = chiSquare / Math.max(1, all[1] - unknowns);
      double[] errors = errors(inverse, scatter, reduced);
      return new JointFit(
          estimates(0, 3, errors),
          estimates(3, MODEL, errors),
          offsets(errors),
          rms(all),
          rms(flat),
          rms(chip),
          (int) all[1] / 2,
          total - (int) all[1] / 2,
          reduced,
          iterations,
          converged);
    }

    private double[] errors(double[][] inverse, double[][] scatter, double reduced) {
      double[] errors = new double[size];
      Arrays.fill(errors, Double.NaN);
      if (inverse == null) {
        return errors;
      }
      int n = kicks.size();
      double small = n > 1 ? n / (n - 1.0) : 1;
      for (int k = 0; k < size; k++) {
        double sandwich = 0;
        for (int i = 0; i < size; i++) {
          for (int j = 0; j < size; j++) {
            sandwich += inverse[k][i] * scatter[i][j] * inverse[k][j];
          }
        }
        double variance = Math.max(inverse[k][k] * reduced, sandwich * small);
        errors[k] = variance > 0 ? Math.sqrt(variance) : Double.NaN;
      }
      return errors;
    }

    private List<Estimate> estimates(int from, int to, double[] errors) {
      List<Estimate> list = new ArrayList<>();
      boolean flat = from == 0;
      boolean any = kicks.stream().anyMatch(k -> (k.kind() == KickKind.FLAT) == flat);
      for (int k = from; k < to && any; k++) {
        Parameter p = shared.get(k).withValue(values[k]);
        boolean bound = p.estimated() && (values[k] <= p.min() || values[k] >= p.max());
        boolean unknown = p.estimated() && !(errors[k] < 0.5 * p.scale());
        Optional<String> reason = unknown ? Optional.of("no kick determines it") : Optional.empty();
        list.add(new Estimate(p, p.estimated() ? errors[k] : Double.NaN, reason, bound));
      }
      return list;
    }

    private Map<Integer, JointFit.Offset> offsets(double[] errors) {
      Map<Integer, JointFit.Offset> offsets = new LinkedHashMap<>();
      for (int c = 0; c < cameraIds.length; c++) {
        CameraView view = problem.cameras().get(cameraIds[c]);
        int k = MODEL + 2 * c;
        offsets.put(
            cameraIds[c],
            new JointFit.Offset(
                view.offsetX() + values[k],
                view.offsetY() + values[k + 1],
                errors[k],
                errors[k + 1]));
      }
      return offsets;
    }

    private double rms(double[] sums) {
      return sums[1] > 0 ? 1000 * Math.sqrt(sums[0] / sums[1]) : Double.NaN;
    }
  }
}

package fieldcal.fit;

import fieldcal.ball.Parameter;
import fieldcal.fit.joint.KickTerm;
import fieldcal.fit.joint.SharedModel;
import fieldcal.fit.joint.SharedProblem;
import fieldcal.fit.joint.SharedProblem.Prior;
import fieldcal.fit.joint.SharedSolution;
import fieldcal.fit.joint.SharedSolution.StopReason;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Fits all kicks at once: one model, one offset per camera, and position, velocity and time of each kick.
 *
 * <p>Uses what partial kicks know, each observation with its weight. The closed forms are brought to the kernel of {@link fieldcal.fit.joint}, which also says what the standard errors assume; outliers are judged again
 * after each solution. Immutable and thread-safe.
 */
public final class JointFitter {
  /** Outliers settle within that many rounds. */
  private static final int OUTLIER_ROUNDS = 3;

  /** Weak knowledge of the model's parameters, so that one that no kick determines stays where it is: that many scales. */
  private static final double EXPECTED = 1000;

  /** Scale of an offset, m: what cameras of the league disagree by once the first estimate was taken out. */
  private static final double OFFSET_SCALE = 0.01;

  /** A parameter whose error is more than that share of its scale is not determined. */
  private static final double DETERMINED = 0.5;

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
    private final int[] cameraIds;
    private final CameraContrasts contrasts;
    private final List<Parameter> globals;
    private final SharedSolver solver = SharedSolver.withDefaults().settlingVariants();
    private int iterations;

    Run(JointProblem problem) {
      this.problem = problem;
      cameraIds =
          problem.fits().stream()
              .flatMapToInt(f -> Arrays.stream(f.kick().observations().cameras()))
              .distinct()
              .sorted()
              .toArray();
      List<int[]> together =
          problem.fits().stream()
              .map(f -> Arrays.stream(f.kick().observations().cameras()).map(this::slot).toArray())
              .toList();
      contrasts = CameraContrasts.of(cameraIds.length, together);
      globals = globals();
    }

    private int slot(int camera) {
      return Arrays.binarySearch(cameraIds, camera);
    }

    private boolean has(KickKind kind) {
      return problem.fits().stream().anyMatch(f -> f.kind() == kind);
    }

    private List<Parameter> globals() {
      List<Parameter> all = new ArrayList<>();
      for (Parameter p : problem.flat().parameters()) {
        all.add(has(KickKind.FLAT) ? p.withValue(p.clamp(p.value())) : p.fixed());
      }
      for (Parameter p : problem.chip().parameters()) {
        boolean given = p.name().equals("accRoll") && problem.chipRoll().isPresent();
        Parameter start =
            given
                ? p.withValue(problem.chipRoll().getAsDouble()).fixed()
                : p.withValue(p.clamp(p.value()));
        all.add(has(KickKind.CHIP) ? start : start.fixed());
      }
      for (int k = 0; k < contrasts.size(); k++) {
        for (String axis : new String[] {"x", "y"}) {
          String name = "contrast " + axis + " " + (k + 1) + " of the cameras' offsets";
          Parameter p =
              new Parameter(name, "m", 0, OFFSET_SCALE, -1, 1, true, "starts at none");
          all.add(problem.offsets() ? p : p.fixed());
        }
      }
      return all;
    }

    private List<Prior> priors() {
      List<Prior> priors = new ArrayList<>();
      for (int k = 0; k < globals.size(); k++) {
        Parameter p = globals.get(k);
        double deviation = EXPECTED * p.scale();
        priors.add(
            k < FlightTerm.OFFSETS ? new Prior(p.value(), 1 / (deviation * deviation)) : Prior.NONE);
      }
      return priors;
    }

    /** The state that {@link FlightTerm} predicts with. */
    private double[] state(double[] values) {
      double[] state = Arrays.copyOf(values, FlightTerm.OFFSETS + 2 * cameraIds.length);
      for (int c = 0; c < cameraIds.length; c++) {
        for (int axis = 0; axis < 2; axis++) {
          state[FlightTerm.OFFSETS + 2 * c + axis] =
              contrasts.offset(values, FlightTerm.OFFSETS, c, axis);
        }
      }
      return state;
    }

    private FlightTerm term(KickFit fit) {
      Observations seen = fit.kick().observations();
      int[] slot = IntStream.range(0, seen.size()).map(i -> slot(seen.camera(i))).toArray();
      return FlightTerm.of(fit, FlightData.of(seen, problem.cameras()), slot);
    }

    private SharedSolution<double[]> solve(
        List<FlightTerm> kicks, List<double[]> starts, double[] values) {
      List<Parameter> at =
          IntStream.range(0, values.length)
              .mapToObj(k -> globals.get(k).withValue(values[k]))
              .toList();
      double[] weights = new double[kicks.size()];
      Arrays.fill(weights, 1);
      SharedModel<double[]> model = this::state;
      SharedSolution<double[]> solution =
          solver.solve(
              new SharedProblem<>(model, kicks, starts, at, priors(), List.of(), weights));
      iterations += solution.iterations();
      return solution;
    }

    JointFit fit() {
      List<FlightTerm> kicks = problem.fits().stream().map(this::term).toList();
      SharedSolution<double[]> solution =
          solve(
              kicks,
              kicks.stream().map(FlightTerm::start).toList(),
              globals.stream().mapToDouble(Parameter::value).toArray());
      for (int round = 0; round < OUTLIER_ROUNDS; round++) {
        List<FlightTerm> before = kicks(solution);
        double[] state = solution.state();
        List<FlightTerm> screened = new ArrayList<>();
        for (int k = 0; k < before.size(); k++) {
          screened.add(
              before.get(k).screened(solution.own(k), state, settings.outlierDistance()));
        }
        if (screened.equals(before)) {
          break;
        }
        solution = solve(screened, solution.own(), solution.values());
      }
      return result(solution);
    }

    private static List<FlightTerm> kicks(SharedSolution<double[]> solution) {
      List<FlightTerm> kicks = new ArrayList<>();
      for (KickTerm<double[]> kick : solution.kicks()) {
        kicks.add((FlightTerm) kick);
      }
      return kicks;
    }

    private JointFit result(SharedSolution<double[]> solution) {
      List<FlightTerm> kicks = kicks(solution);
      double[] state = solution.state();
      double[] squares = new double[2];
      int[] rows = new int[2];
      int observations = 0;
      for (int k = 0; k < kicks.size(); k++) {
        FlightTerm kick = kicks.get(k);
        int kind = kick.kind() == KickKind.FLAT ? 0 : 1;
        squares[kind] += kick.squaredResiduals(solution.own(k), state);
        rows[kind] += kick.rows();
        observations += kick.observations();
      }
      int used = (rows[0] + rows[1]) / 2;
      Optional<double[][]> covariance = solution.covariance();
      return new JointFit(
          has(KickKind.FLAT) ? estimates(solution, covariance, 0, FlightTerm.CHIP) : List.of(),
          has(KickKind.CHIP)
              ? estimates(solution, covariance, FlightTerm.CHIP, FlightTerm.OFFSETS)
              : List.of(),
          offsets(state, covariance),
          rms(squares[0] + squares[1], rows[0] + rows[1]),
          rms(squares[0], rows[0]),
          rms(squares[1], rows[1]),
          used,
          observations - used,
          solution.reducedChiSquare(),
          iterations,
          solution.stopReason() == StopReason.CONVERGED);
    }

    private List<Estimate> estimates(
        SharedSolution<double[]> solution, Optional<double[][]> covariance, int from, int to) {
      List<Estimate> list = new ArrayList<>();
      for (Parameter p : solution.globals().subList(from, to)) {
        int k = from + list.size();
        double error =
            p.estimated() && covariance.isPresent()
                ? Math.sqrt(covariance.get()[k][k])
                : Double.NaN;
        boolean bound = p.estimated() && (p.value() <= p.min() || p.value() >= p.max());
        boolean unknown = p.estimated() && !(error < DETERMINED * p.scale());
        Optional<String> reason = unknown ? Optional.of("no kick determines it") : Optional.empty();
        list.add(new Estimate(p, error, reason, bound));
      }
      return list;
    }

    private Map<Integer, JointFit.Offset> offsets(
        double[] state, Optional<double[][]> covariance) {
      Map<Integer, JointFit.Offset> offsets = new LinkedHashMap<>();
      for (int c = 0; c < cameraIds.length; c++) {
        CameraView view = problem.cameras().get(cameraIds[c]);
        int k = FlightTerm.OFFSETS + 2 * c;
        offsets.put(
            cameraIds[c],
            new JointFit.Offset(
                view.offsetX() + state[k],
                view.offsetY() + state[k + 1],
                offsetError(covariance, c, 0),
                offsetError(covariance, c, 1)));
      }
      return offsets;
    }

    private double offsetError(Optional<double[][]> covariance, int camera, int axis) {
      return problem.offsets() && contrasts.determines(camera) && covariance.isPresent()
          ? contrasts.error(covariance.get(), FlightTerm.OFFSETS, camera, axis)
          : Double.NaN;
    }

    private double rms(double squares, int rows) {
      return rows > 0 ? 1000 * Math.sqrt(squares / rows) : Double.NaN;
    }
  }
}

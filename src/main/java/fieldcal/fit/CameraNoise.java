package fieldcal.fit;

import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.apache.commons.math3.analysis.polynomials.PolynomialFunction;
import org.apache.commons.math3.fitting.PolynomialCurveFitter;
import org.apache.commons.math3.fitting.WeightedObservedPoints;

/**
 * Measures each camera's noise on the ball that rests before a kick: there every deviation from the mean is noise. Where no ball rested, because kickers pushed it first, {@link #inMotion} takes the deviations from short smooth stretches of its path.
 *
 * <p>The scale is the median of the squared whitened deviations, so that a few false detections do not matter. It is never below {@link #FLOOR}, nor below what a
 * grid of the coordinates adds: a ball that rests in one cell of a grid does not scatter at all, and may be half a cell off.
 */
public final class CameraNoise {
  /** Fewer resting detections per kick do not determine the noise, since their own mean is taken off. */
  private static final int FEWEST_PER_KICK = 8;

  /** With fewer in all, the noise is more than 10 % uncertain. */
  private static final int FEWEST = 50;

  /**
   * Least noise of any camera per axis, m. Chosen below the 0.7 mm of good real cameras on a resting ball, and below the 1.1 mm that good fits of ten
   * real matches leave in addition (1.3 mm RMS; DESIGN, section 6): the closed forms are never right to less, so that cleaner data cannot determine more.
   */
  public static final double FLOOR = 3e-4;

  /** Coordinates are compared in these units, m: the resolution of vision's 32-bit millimetres at the field's end. */
  private static final double RESOLUTION = 1e-6;

  /** A finer grid is ignored, m: it adds less than a third of the floor. */
  private static final double FINEST_GRID = 3e-4;

  /** Fewest different coordinates that show a grid: by chance this many are all even in one of four thousand cameras. */
  private static final int FEWEST_VALUES = 12;

  /** Number of detections in a stretch of a moving ball; of fewer, a parabola leaves too little. */
  private static final int STRETCH = 8;

  /** Over a longer stretch a ball does not move on a parabola, s; eight detections at 50 Hz. */
  private static final double LONGEST_STRETCH = 0.16;

  /** Time stamps jitter by up to 1.3 ms (ten matches of 2026): a slower ball moves less than the noise of good cameras meanwhile, m/s. */
  private static final double SLOW = 0.5;

  private static final PolynomialCurveFitter PARABOLA = PolynomialCurveFitter.create(2);

  private CameraNoise() {}

  /**
   * The cameras with the noise that the kicks show; those that saw too few resting detections keep theirs. No camera's noise is below its {@link #least}.
   *
   * @param kicks any kind
   * @param views the cameras
   * @return the views with their noise
   */
  public static CameraViews measured(List<Kick> kicks, CameraViews views) {
    List<Map<Integer, Grid>> grids = kicks.stream().map(CameraNoise::grids).toList();
    return measured(grids, kicks.stream().map(k -> squaresAtRest(k, views)).toList(), views);
  }

  /** The same from the {@link #grids} and {@link #squaresAtRest} of each kick. */
  static CameraViews measured(
      List<Map<Integer, Grid>> grids, List<Map<Integer, double[]>> squares, CameraViews views) {
    Map<Integer, Double> least = least(merged(grids));
    Map<Integer, Double> noise = noise(joined(squares), least);
    return views.map(
        v ->
            v.withNoise(
                Math.max(
                    noise.getOrDefault(v.id(), v.noise()), least.getOrDefault(v.id(), FLOOR))));
  }

  /**
   * The lower bound of a camera's noise: {@link #FLOOR} and, where all its coordinates are multiples of a step q, the standard deviation q/√12 of rounding to it.
   *
   * @param kicks any kind
   * @return m, by camera id
   */
  public static Map<Integer, Double> least(List<Kick> kicks) {
    return least(merged(kicks.stream().map(CameraNoise::grids).toList()));
  }

  private static Map<Integer, Double> least(Map<Integer, Grid> grids) {
    Map<Integer, Double> least = new TreeMap<>();
    grids.forEach((camera, grid) -> least.put(camera, Math.hypot(FLOOR, grid.step() / ROUNDING)));
    return least;
  }

  /**
   * Cameras all of whose coordinates are multiples of a step, where rounding to it adds more than {@link #FLOOR}.
   *
   * @param kicks any kind
   * @return the step by camera id, m; cameras without a grid, or with a finer one, are missing
   */
  public static Map<Integer, Double> coarseGrids(List<Kick> kicks) {
    Map<Integer, Double> steps = new TreeMap<>();
    merged(kicks.stream().map(CameraNoise::grids).toList())
        .forEach(
            (camera, grid) -> {
              if (grid.step() / ROUNDING > FLOOR) {
                steps.put(camera, grid.step());
              }
            });
    return steps;
  }

  /** The grids of the cameras that saw a kick, by their ids. */
  static Map<Integer, Grid> grids(Kick kick) {
    Map<Integer, Grid> grids = new TreeMap<>();
    Observations seen = kick.observations();
    for (int i = 0; i < seen.size(); i++) {
      grids.computeIfAbsent(seen.camera(i), c -> new Grid()).add(seen.x(i), seen.y(i));
    }
    return grids;
  }

  private static Map<Integer, Grid> merged(List<Map<Integer, Grid>> kicks) {
    Map<Integer, Grid> all = new TreeMap<>();
    for (Map<Integer, Grid> kick : kicks) {
      kick.forEach((camera, grid) -> all.computeIfAbsent(camera, c -> new Grid()).add(grid));
    }
    return all;
  }

  /** A uniform distribution's width is that many standard deviations. */
  private static final double ROUNDING = Math.sqrt(12);

  /** The largest step that all coordinates of a camera are multiples of. */
  static final class Grid {
    private final Set<Long> values = new HashSet<>();
    private long divisor;

    void add(double x, double y) {
      add(x);
      add(y);
    }

    private void add(double coordinate) {
      if (divisor == 1) {
        return;
      }
      long value = Math.abs(Math.round(coordinate / RESOLUTION));
      divide(value);
      if (values.size() < FEWEST_VALUES) {
        values.add(value);
      }
    }

    /** Adds all coordinates of another grid. */
    void add(Grid other) {
      divide(other.divisor);
      values.addAll(other.values);
    }

    private void divide(long value) {
      long rest = value;
      while (rest != 0) {
        long next = divisor % rest;
        divisor = rest;
        rest = next;
      }
    }

    /** The step, m; 0 without a grid, or when too few different values were seen to determine it. */
    double step() {
      double step = divisor * RESOLUTION;
      return values.size() >= FEWEST_VALUES && step >= FINEST_GRID ? step : 0;
    }
  }

  /**
   * Noise per axis, straight below each camera, at least its {@link #least}.
   *
   * @param kicks any kind; those that did not begin at rest are ignored
   * @param views the cameras; their own noise is not used
   * @return m, by camera id; cameras that saw too little at rest are missing
   */
  public static Map<Integer, Double> atRest(List<Kick> kicks, CameraViews views) {
    return noise(joined(kicks.stream().map(k -> squaresAtRest(k, views)).toList()), least(kicks));
  }

  /** Squared deviations of the ball that rests before a kick, for a camera without noise of its own, by the camera's id. */
  static Map<Integer, double[]> squaresAtRest(Kick kick, CameraViews views) {
    Map<Integer, double[]> squares = new TreeMap<>();
    if (kick.fromRest()) {
      Observations rest = kick.observations().between(Double.NEGATIVE_INFINITY, kick.time() - 0.02);
      FlightData data = FlightData.of(rest, views.map(v -> v.withNoise(1)));
      for (int camera : rest.cameras()) {
        squares.put(camera, squares(data, camera));
      }
    }
    return squares;
  }

  private static Map<Integer, List<Double>> joined(List<Map<Integer, double[]>> kicks) {
    Map<Integer, List<Double>> all = new TreeMap<>();
    for (Map<Integer, double[]> kick : kicks) {
      kick.forEach(
          (camera, squares) -> {
            List<Double> its = all.computeIfAbsent(camera, c -> new ArrayList<>());
            Arrays.stream(squares).forEach(its::add);
          });
    }
    return all;
  }

  private static Map<Integer, Double> noise(
      Map<Integer, List<Double>> squares, Map<Integer, Double> least) {
    Map<Integer, Double> noise = new TreeMap<>();
    squares.forEach(
        (camera, values) -> {
          if (values.size() >= FEWEST) {
            double[] squared = values.stream().mapToDouble(v -> v).toArray();
            double at = RobustScale.ofSquaredDistances(squared);
            noise.put(camera, Math.max(at, least.getOrDefault(camera, FLOOR)));
          }
        });
    return noise;
  }

  private static double[] squares(FlightData data, int camera) {
    int n = 0;
    double[] x = new double[data.size];
    double[] y = new double[data.size];
    int[] index = new int[data.size];
    for (int i = 0; i < data.size; i++) {
      if (data.camera[i] == camera) {
        x[n] = data.x[i];
        y[n] = data.y[i];
        index[n++] = i;
      }
    }
    if (n < FEWEST_PER_KICK) {
      return new double[0];
    }
    double mx = median(x, n);
    double my = median(y, n);
    // About the sample's own centre the squared deviations are too small by the factor (n − 1)/n.
    double correction = n / (n - 1.0);
    double[] squares = new double[n];
    for (int k = 0; k < n; k++) {
      int i = index[k];
      double r1 = data.w11[i] * (x[k] - mx);
      double r2 = data.w21[i] * (x[k] - mx) + data.w22[i] * (y[k] - my);
      squares[k] = (r1 * r1 + r2 * r2) * correction;
    }
    return squares;
  }

  /**
   * Noise per axis on the moving ball, at least its {@link #least}: the residuals of a parabola fitted to short stretches of each camera. Only slow stretches are used if there are enough, since jitter of the time stamps displaces a fast ball.
   *
   * @param kicks any kind
   * @param views the cameras; their own noise is not used
   * @return m, by camera id; cameras that saw too little are missing
   */
  public static Map<Integer, Double> inMotion(List<Kick> kicks, CameraViews views) {
    CameraViews unit = views.map(v -> v.withNoise(1));
    Map<Integer, List<Double>> slow = new TreeMap<>();
    Map<Integer, List<Double>> all = new TreeMap<>();
    for (Kick kick : kicks) {
      Observations seen = kick.observations();
      FlightData data = FlightData.of(seen, unit);
      for (int camera : seen.cameras()) {
        int[] index = IntStream.range(0, data.size).filter(i -> data.camera[i] == camera).toArray();
        for (int from = 0; from + STRETCH <= index.length; from += STRETCH) {
          int[] stretch = Arrays.copyOfRange(index, from, from + STRETCH);
          double span = data.time[stretch[STRETCH - 1]] - data.time[stretch[0]];
          if (span > 0 && span < LONGEST_STRETCH) {
            List<Double> squares = offParabola(data, stretch);
            all.computeIfAbsent(camera, c -> new ArrayList<>()).addAll(squares);
            if (length(data, stretch) < SLOW * span) {
              slow.computeIfAbsent(camera, c -> new ArrayList<>()).addAll(squares);
            }
          }
        }
      }
    }
    all.replaceAll((c, s) -> slow.getOrDefault(c, List.of()).size() >= FEWEST ? slow.get(c) : s);
    return noise(all, least(kicks));
  }

  private static double length(FlightData data, int[] stretch) {
    int first = stretch[0];
    int last = stretch[STRETCH - 1];
    return Math.hypot(data.x[last] - data.x[first], data.y[last] - data.y[first]);
  }

  /** Squared whitened distances from the parabola fitted to a stretch, enlarged since the fit takes three degrees of freedom per axis. */
  private static List<Double> offParabola(FlightData data, int[] stretch) {
    WeightedObservedPoints x = new WeightedObservedPoints();
    WeightedObservedPoints y = new WeightedObservedPoints();
    double start = data.time[stretch[0]];
    for (int i : stretch) {
      x.add(data.time[i] - start, data.x[i]);
      y.add(data.time[i] - start, data.y[i]);
    }
    PolynomialFunction px = new PolynomialFunction(PARABOLA.fit(x.toList()));
    PolynomialFunction py = new PolynomialFunction(PARABOLA.fit(y.toList()));
    double correction = STRETCH / (STRETCH - 3.0);
    List<Double> squares = new ArrayList<>();
    for (int i : stretch) {
      double t = data.time[i] - start;
      squares.add(correction * data.squared(i, data.x[i] - px.value(t), data.y[i] - py.value(t)));
    }
    return squares;
  }

  private static double median(double[] values, int n) {
    double[] sorted = Arrays.copyOf(values, n);
    Arrays.sort(sorted);
    return 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]);
  }
}

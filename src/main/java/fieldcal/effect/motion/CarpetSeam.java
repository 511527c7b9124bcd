package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.Line;
import java.util.ArrayList;
import java.util.List;

/**
 * A straight seam of the carpet, the points with x·cos(normal) + y·sin(normal) = distance. A ball that rolls or slides over it, either way, first loses a part of its speed across the seam, and then its velocity turns; a ball in flight does not touch
 * it. A turn that would throw the ball back leaves it moving along the seam. A rolling ball goes on rolling, a sliding one keeps its spin. Field frame.
 *
 * @param loss part of the speed across the seam that is lost (–), 0 = none
 * @param turn by how much the path turns to the left (counter-clockwise), whichever way it crosses, rad
 * @param normal direction across the seam, rad, 0 = along x, counter-clockwise; which of the two senses it has does not matter
 * @param distance of the seam from the field's centre along the normal, m; negative = on the other side of the centre
 */
public record CarpetSeam(double loss, double turn, double normal, double distance) implements Line {
  private static final String ID = "carpet_seam";

  /** Directions across the seams that a search begins with: carpets are laid along the field's sides, sometimes aslant. */
  private static final double[] NORMALS = {0, Math.PI / 2, Math.PI / 4, -Math.PI / 4};

  /** Lines per direction; chosen: a metre or two from one to the next, which a search of the distance bridges. */
  private static final int LINES = 6;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public CarpetSeam {
    EffectParameters.requireFinite(ID, loss, turn, normal, distance);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "A seam of the carpet brakes or turns balls that roll over it.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "loss", "", loss, 0.02, -0.5, 0.9, true, "chosen wide; seams take some percent"),
        new Parameter("turn", "rad", turn, 0.01, -0.5, 0.5, true, "chosen wide; some hundredths"),
        EffectParameters.place(
            "normal", "rad", normal, -2 * Math.PI, 2 * Math.PI, "direction across the seam"),
        EffectParameters.place(
            "distance", "m", distance, -20, 20, "from the centre along the normal"));
  }

  @Override
  public CarpetSeam withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 4);
    return new CarpetSeam(v[0], v[1], v[2], v[3]);
  }

  @Override
  public boolean isAbsent() {
    return loss == 0 && turn == 0;
  }

  @Override
  public List<String> magnitudes() {
    return List.of("loss", "turn");
  }

  @Override
  public List<List<String>> choices() {
    return List.of(List.of("loss"), List.of("turn"), List.of("loss", "turn"));
  }

  /** Lines along the sides of the field and across its corners, evenly over where balls were seen. */
  @Override
  public List<Effect> candidates(Arena arena) {
    double x = 0.5 * (arena.x0() + arena.x1());
    double y = 0.5 * (arena.y0() + arena.y1());
    List<Effect> seams = new ArrayList<>();
    for (double across : NORMALS) {
      double cos = Math.cos(across);
      double sin = Math.sin(across);
      double middle = x * cos + y * sin;
      double reach =
          0.5
              * ((arena.x1() - arena.x0()) * Math.abs(cos)
                  + (arena.y1() - arena.y0()) * Math.abs(sin));
      for (int i = 1; i <= LINES; i++) {
        seams.add(new CarpetSeam(0, 0, across, middle + (2.0 * i / (LINES + 1) - 1) * reach));
      }
    }
    return List.copyOf(seams);
  }

  @Override
  public List<String> places() {
    return List.of("normal", "distance");
  }

  @Override
  public double normalX() {
    return Math.cos(normal);
  }

  @Override
  public double normalY() {
    return Math.sin(normal);
  }

  @Override
  public void cross(double[] velocity) {
    double cos = Math.cos(normal);
    double sin = Math.sin(normal);
    double across = velocity[0] * cos + velocity[1] * sin;
    double along = velocity[1] * cos - velocity[0] * sin;
    double left = (1 - loss) * across;
    double turnCos = Math.cos(turn);
    double turnSin = Math.sin(turn);
    double newAcross = left * turnCos - along * turnSin;
    double newAlong = along * turnCos + left * turnSin;
    if (newAcross * across < 0) {
      // A path that hardly crosses the seam is turned into it, not back.
      newAlong = Math.copySign(Math.hypot(newAcross, newAlong), along);
      newAcross = 0;
    }
    velocity[0] = newAcross * cos - newAlong * sin;
    velocity[1] = newAcross * sin + newAlong * cos;
  }
}

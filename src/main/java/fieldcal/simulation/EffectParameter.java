package fieldcal.simulation;

/**
 * A parameter of a simulated effect.
 *
 * @param name as in commands
 * @param kind how its value is written
 * @param min smallest number that is accepted, in the unit of the parameter
 * @param max largest number that is accepted, in the unit of the parameter
 */
public record EffectParameter(String name, Kind kind, double min, double max) {

  /** How a value is written. */
  public enum Kind {
    /** A number. */
    NUMBER,
    /** A camera's number or {@code all}. */
    CAMERA,
    /** A rectangle: {@code [x0,x1,y0,y1]} or {@code x0/x1/y0/y1}, m. */
    REGION,
    /** {@code yellow}, {@code blue} or {@code all}. */
    TEAM,
    /** A robot's number or {@code all}. */
    ROBOT
  }

  static EffectParameter number(String name, double min, double max) {
    return new EffectParameter(name, Kind.NUMBER, min, max);
  }

  static EffectParameter camera() {
    return new EffectParameter("camera", Kind.CAMERA, 0, 63);
  }

  static EffectParameter region(String name) {
    return new EffectParameter(name, Kind.REGION, -100, 100);
  }

  static EffectParameter team() {
    return new EffectParameter("team", Kind.TEAM, 0, 0);
  }

  static EffectParameter robot() {
    return new EffectParameter("robot", Kind.ROBOT, 0, 63);
  }
}

package fieldcal.effect;

import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import java.util.List;
import java.util.Optional;

/**
 * One cause that the simple model leaves out, with its numbers. Immutable; the same cause with other numbers is another value ({@link
 * #withParameters}).
 *
 * <p>Parameters come in the order of the design's table: the magnitude first; those that only say where or which (camera, robot, region) are marked
 * as not estimated. With all magnitudes zero the cause is absent, and every prediction is the same to the last bit as without it.
 */
public interface Effect {

  /**
   * The name in files and commands.
   *
   * @return lower case with underscores
   */
  String id();

  /**
   * What it is, for operators.
   *
   * @return one sentence
   */
  String sentence();

  /**
   * Its numbers.
   *
   * @return magnitude first, always in the same order
   */
  List<Parameter> parameters();

  /**
   * The same cause with other numbers.
   *
   * @param values in the order of {@link #parameters()}, finite
   * @return the changed effect
   * @throws IllegalArgumentException when the count is wrong or a value is not finite
   */
  Effect withParameters(double... values);

  /**
   * Whether it changes nothing because all its magnitudes are zero.
   *
   * @return true when absent
   */
  boolean isAbsent();

  /**
   * The parameters that make it absent when they are all zero.
   *
   * @return names; the first parameter's alone unless an effect says otherwise
   */
  default List<String> magnitudes() {
    return List.of(parameters().get(0).name());
  }

  /**
   * Whether it depends on the time since the beginning of the session, so that a clock is needed to predict with it.
   *
   * @return false unless an effect says otherwise
   */
  default boolean changesWithTime() {
    return false;
  }

  /**
   * Whether the data of a recording can show it at all.
   *
   * @param arena what was recorded
   * @return true unless something is missing: chips, a second camera, commands
   */
  default boolean canShowIn(Arena arena) {
    return true;
  }

  /**
   * Where it may act: absent copies with the cameras, robots, regions, lines or times at which a search begins. A search improves the best of them by
   * changing the {@linkplain #places() place parameters}.
   *
   * @param arena what was recorded
   * @return at least one where it {@linkplain #canShowIn can show}; the effect itself, absent, unless an effect says otherwise
   */
  default List<Effect> candidates(Arena arena) {
    return List.of(withNone());
  }

  /**
   * The places at which a search begins, if these are made of tiles. A search then uses them instead of the {@linkplain #candidates candidates}. Where this effect acts within the arena, its own bounds are bounds of tiles, too: a search that has found it compares its place with all
   * others.
   *
   * @param arena what was recorded
   * @return empty unless an effect says otherwise
   */
  default Optional<Mosaic> mosaic(Arena arena) {
    return Optional.empty();
  }

  /**
   * The same cause with a place that reaches hardly farther than the balls of a recording: where none was, its bounds are arbitrary.
   *
   * @param arena what was recorded
   * @return an effect that does the same to these balls; the effect itself unless an effect says otherwise
   */
  default Effect within(Arena arena) {
    return this;
  }

  /**
   * The parameters that say where or when it acts and that a search may move: bounds of a region, a line, an instant. What it acts on (camera, robot) is none of
   * them.
   *
   * @return names, empty unless an effect says otherwise
   */
  default List<String> places() {
    return List.of();
  }

  /**
   * Sets of magnitudes that may be free together, simplest first: the pose of a camera may be wrong in its height alone, or in its tilt and its place.
   *
   * @return at least one; all magnitudes at once unless an effect says otherwise
   */
  default List<List<String>> choices() {
    return List.of(magnitudes());
  }

  /**
   * Whether its magnitude differs from kick to kick, so that it has a mean and a scatter: what a kicker does to the ball.
   *
   * @return false unless an effect says otherwise
   */
  default boolean differsFromKickToKick() {
    return false;
  }

  /**
   * Whether the mean of what differs from kick to kick has to be estimated. It is not estimated if it is one of the ball's parameters, or zero by symmetry.
   *
   * @return true unless an effect says otherwise
   */
  default boolean hasOwnMean() {
    return true;
  }

  /**
   * Whether it acts on the ball through the ball's spin alone: where the spin is not determined, this effect is not determined either.
   *
   * @return false unless an effect says otherwise
   */
  default boolean actsThroughSpin() {
    return false;
  }

  /**
   * Effects without which this one does nothing, at usual values: there is no wind without drag. A search proposes them together.
   *
   * @return empty unless an effect says otherwise
   */
  default List<Effect> companions() {
    return List.of();
  }

  /**
   * Strong versions from which a search begins, for a law that replaces another and cannot be reached from its absence in small steps.
   *
   * @return empty for all that grow from zero
   */
  default List<Effect> starts() {
    return List.of();
  }

  /**
   * Starts of another form of such a law, that a search tries where the law holds: one that differs in a number that is not estimated.
   *
   * @return empty unless a law says otherwise
   */
  default List<Effect> forms() {
    return List.of();
  }

  /**
   * What is known of the ball's own parameters while this effect is in the model. For example, kSwitch absorbs the mean spin as long as the model has no spin, and follows from mechanics otherwise.
   *
   * @return empty unless an effect says otherwise
   */
  default List<BallKnowledge> ballKnowledge() {
    return List.of();
  }

  /**
   * The apparent size of its magnitudes if the effect is absent and the carpet resists the turning of a ball that still slides. The simple model has no such resistance while the ball slides.
   *
   * @param ball the simple model of flat kicks, or what it is where one kick was
   * @return one for each of {@link #magnitudes()}, in its unit; 0 unless an effect says otherwise
   */
  default double[] imitatedBy(FlatModel ball) {
    return new double[magnitudes().size()];
  }

  /**
   * Where a ball must have been on the carpet for it to matter. A path that never comes there is the same without it, which spares the search most of its work.
   *
   * @return empty unless an effect says otherwise: anywhere
   */
  default Optional<Area> reach() {
    return Optional.empty();
  }

  /**
   * Whether a calibration of the simple model allows for it, so that it does not change the ball's parameters: it takes the offsets of cameras out of the detections, and fits each kick's own velocity, whatever the robot was commanded.
   *
   * @return false unless an effect says otherwise
   */
  default boolean isAllowedForByCalibration() {
    return false;
  }

  /**
   * What it acts on, if not on everything: a camera, a robot. Two effects with the same id and subject are the same cause with other numbers.
   *
   * @return a text for comparison, made of the parameters that are neither estimated nor places
   */
  default String subject() {
    StringBuilder text = new StringBuilder();
    for (Parameter p : parameters()) {
      if (!p.estimated() && !places().contains(p.name())) {
        text.append(p.name()).append('=').append(p.value()).append(' ');
      }
    }
    return text.toString();
  }

  /**
   * The variables on which its action depends, named as those of learned terms.
   *
   * @return empty unless an effect says otherwise
   */
  default List<String> dependsOn() {
    return List.of();
  }

  /**
   * A name for the steps of a search, which tells effects with the same id apart even where no parameter does.
   *
   * @return the id unless an effect says otherwise
   */
  default String label() {
    return id();
  }

  /**
   * The same effect with more magnitudes, which show finer detail.
   *
   * @return the effect as it is, in those magnitudes; empty unless an effect says otherwise
   */
  default Optional<Effect> finer() {
    return Optional.empty();
  }

  /**
   * The same effect with all magnitudes zero.
   *
   * @return an absent effect
   */
  default Effect withNone() {
    Effect none = this;
    for (String name : magnitudes()) {
      none = none.with(name, 0);
    }
    return none;
  }

  /**
   * The same cause with one number changed.
   *
   * @param name of the parameter
   * @param value finite
   * @return the changed effect
   * @throws IllegalArgumentException when there is no such parameter
   */
  default Effect with(String name, double value) {
    double[] values = parameters().stream().mapToDouble(Parameter::value).toArray();
    values[index(name)] = value;
    return withParameters(values);
  }

  /**
   * One number.
   *
   * @param name of the parameter
   * @return its value
   * @throws IllegalArgumentException when there is no such parameter
   */
  default double value(String name) {
    return parameters().get(index(name)).value();
  }

  private int index(String name) {
    List<Parameter> all = parameters();
    for (int i = 0; i < all.size(); i++) {
      if (all.get(i).name().equals(name)) {
        return i;
      }
    }
    throw new IllegalArgumentException(id() + " has no parameter '" + name + "'");
  }
}

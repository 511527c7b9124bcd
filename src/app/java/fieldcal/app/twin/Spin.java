package fieldcal.app.twin;

import fieldcal.effect.Effect;

/**
 * Spin that a diagnosis found.
 *
 * @param effect with its mean
 * @param scatter from kick to kick, in units of rolling spin
 */
record Spin(Effect effect, double scatter) {
  double number(String name) {
    return effect.value(name);
  }
}

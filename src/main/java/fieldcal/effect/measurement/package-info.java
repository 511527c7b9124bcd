/**
 * Effects that change what a camera reports of a ball: its place and tilt, lens, clock, shutter, and the ball's assumed height.
 *
 * <p>One class each, named after the cause. Errors of a calibration are <em>published minus true</em>; the published calibration is what the
 * program knows, so the effects compute the true one from it. Used through {@link fieldcal.effect.EffectCatalogue}.
 */
package fieldcal.effect.measurement;

/**
 * Effects that change how the ball moves: air, spin, slope, carpet, bounces, and what a robot makes of its command.
 *
 * <p>One class each, named after the cause; formulas and signs are those of the design's table of effects. Used through {@link
 * fieldcal.effect.EffectCatalogue}.
 */
package fieldcal.effect.motion;

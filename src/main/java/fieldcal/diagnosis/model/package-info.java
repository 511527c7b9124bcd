/**
 * A recording as the stages of the diagnosis see it: kicks with their whitened observations, and a ball model with any effects in it, as terms of the kernel in {@link fieldcal.fit.joint}. Knows effects by
 * their interface alone.
 */
package fieldcal.diagnosis.model;

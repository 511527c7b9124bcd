/**
 * A calibrated model in the form that other programs read: simulators, visions, team software. Each target is one small descriptor in the resources of this package; {@code format} knows the forms of
 * files. Used by the command {@code export} and by the console.
 */
package fieldcal.app.export;

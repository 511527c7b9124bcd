/**
 * Which kicks and which of their detections a diagnosis is made from, and what each kick is taken for: revised only together with the model, by which a kick stands out. What is not a free ball at a kick's begin or end is left out, a kick
 * taken for the other kind is changed, one that no model explains is left out when the others are explained; each with its reason.
 */
package fieldcal.diagnosis.screening;

/**
 * Which kicks and which of their detections a diagnosis is made from, and what each kick is taken for: revised together with the model, which shows the kicks that stand out. A beginning or end of a kick in which the ball is not free is left out, and a kick
 * that was taken for the wrong kind is changed. A kick that no model explains is left out, with the reason, once the others are explained.
 */
package fieldcal.diagnosis.screening;

/**
 * The only place where names are given: which of the effects that a search kept are causes, which are the form of another, which cannot be told apart, under a false-alarm budget over everything that was tried.
 */
package fieldcal.diagnosis.decision;

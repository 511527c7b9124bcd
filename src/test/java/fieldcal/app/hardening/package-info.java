/** What arrives from outside — files, packets, requests — in every broken form: one clear error, or the part of it that can be used. */
package fieldcal.app.hardening;

// Sentences of the terms: those of the report from its glossary, those of the studio alone from its words.
import { boundsOfAStatistic, deviation, numericalError, randomInput, unknownInputAnInterval } from 'virtual:glossary';
import { words } from '../words.ts';

export const terms = { boundsOfAStatistic, deviation, numericalError, randomInput, unknownInputAnInterval, ...words.terms };

export type TermName = keyof typeof terms;

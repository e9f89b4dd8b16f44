// Makes a folder from a template, with the first name that is free.
import { ask, Refusal } from './wire.ts';

const mostTried = 100;

export async function makeFrom(template: string): Promise<string> {
  for (let number = 1; ; number += 1) {
    const folder = number === 1 ? template : `${template}-${number}`;
    try {
      const made = await ask<{ study: string; model: string }>('POST', '/api/new', { template, folder });
      return made.study;
    } catch (error) {
      if (!(error instanceof Refusal) || error.status !== 409 || number >= mostTried) throw error;
    }
  }
}

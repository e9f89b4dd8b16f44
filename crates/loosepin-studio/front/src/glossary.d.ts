// Terms of the report that the page of the studio shows too: see ../glossary.ts.
declare module 'virtual:glossary' {
  export const deviation: string;
  export const randomInput: string;
  export const unknownInputAnInterval: string;
  export const boundsOfAStatistic: string;
  export const numericalError: string;
}

let tag = $state('en');

/** The language in which numbers and dates are written, as a BCP 47 tag. */
export const locale = {
  get tag(): string {
    return tag;
  },
  set tag(spoken: string) {
    tag = spoken;
  },
};

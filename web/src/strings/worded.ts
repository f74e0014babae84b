/** What a catalogue in any language holds, by what the English one does. */
export type Worded<T> = T extends string
  ? string
  : T extends (...given: infer Given) => infer Said
    ? (...given: Given) => Worded<Said>
    : T extends readonly (infer Each)[]
      ? readonly Worded<Each>[]
      : { readonly [Key in keyof T]: Worded<T[Key]> };

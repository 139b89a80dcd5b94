#lang racket/base
;; Which known names an unknown one may have been meant for: those a few slips
;; of the finger away, or else those that it begins, as matrix begins
;; matrix-by-rows.  Short names have too many neighbours, and are the symbols
;; of physics; so about one slip is allowed for four letters, and below four
;; letters there are no suggestions.  Predicates are rarely meant, unless one was typed.

(require (only-in racket/list add-between take)
         (only-in "message-words.rkt" joined))

(provide likely-names nearest-names alternatives did-you-mean among)

(define most-suggestions 3)

;; name : symbol; known : list of symbols  ->  at most three of them, likely first
(define (likely-names name known)
  (define text (symbol->string name))
  (define length (string-length text))
  (cond [(< length 4) '()]
        [else
         (define others (filter (lambda (k) (other-than? k name)) known))
         (define near (nearest text (min 3 (quotient (add1 length) 4)) others))
         (take-some (if (null? near) (completions text others) near))]))

(define (other-than? known name)
  (not (or (eq? known name) (and (predicate? known) (not (predicate? name))))))

(define (predicate? name) (regexp-match? #rx"[?]$" (symbol->string name)))

;; Among few names a slip may be allowed where a word has but three letters.
(define (nearest-names text known)
  (nearest text (max 1 (quotient (string-length text) 2)) known))

;; a, b or c
(define (alternatives names)
  (apply string-append
         (add-between (map symbol->string names) ", " #:before-last " or ")))

;; The end of a sentence about an unknown name; "" where no known name is near.
(define (did-you-mean near)
  (if (null? near) "" (format "; did you mean ~a?" (alternatives near))))

;; The end of a message about a name that is not among the known: the likely one, and all of them.
(define (among name known)
  (format "~a\n  there are: ~a"
          (did-you-mean (nearest-names (symbol->string name) known))
          (joined (map symbol->string known))))

;; The names at the smallest distance that is allowed.
(define (nearest text allowed known)
  (define-values (found distance)
    (for/fold ([found '()] [least allowed]) ([k (in-list known)])
      (define d (slips text (symbol->string k) least))
      (cond [(not d) (values found least)]
            [(< d least) (values (list k) d)]
            [else (values (cons k found) least)])))
  found)

(define (completions text known)
  (define beginning (string-append text "-"))
  (define n (string-length beginning))
  (define (begins? k)
    (define s (symbol->string k))
    (and (> (string-length s) n) (string-ci=? beginning (substring s 0 n))))
  (filter begins? known))

(define (take-some names)
  (take (sort names symbol<?) (min most-suggestions (length names))))

;; How many letters were left out, put in or exchanged for another, or swapped
;; with their neighbour, upper and lower case being one; #f if more than `most`.
;; Rows of the table of distances between beginnings of s and of t, where
;; `above` is the row before, and `higher` the one before that.
(define (slips s t most)
  (define m (string-length s))
  (define n (string-length t))
  (define (same? i j)
    (char-ci=? (string-ref s (sub1 i)) (string-ref t (sub1 j))))
  (define (next-row i above higher)
    (define row (make-vector (add1 n) i))
    (for ([j (in-range 1 (add1 n))])
      (define straight
        (min (add1 (vector-ref above j))
             (add1 (vector-ref row (sub1 j)))
             (+ (vector-ref above (sub1 j)) (if (same? i j) 0 1))))
      (define swapped?
        (and (> i 1) (> j 1) (same? i (sub1 j)) (same? (sub1 i) j)))
      (vector-set! row j (if swapped?
                             (min straight (add1 (vector-ref higher (- j 2))))
                             straight)))
    row)
  (and (<= (abs (- m n)) most)
       (let loop ([i 1] [above (build-vector (add1 n) values)] [higher #f])
         (cond [(<= i m) (loop (add1 i) (next-row i above higher) above)]
               [else (define d (vector-ref above n)) (and (<= d most) d)]))))

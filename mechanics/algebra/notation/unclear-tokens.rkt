#lang racket/base
;; Formulas that two readers could understand differently: sin x/2, p^2/2m, x^1/2, k(x - x0), mgh.
;;
;; Of clear ones, this settles which parentheses hold the arguments of a call, f(x), and which a
;; factor, m (b + c).

(require "formula-tokens.rkt" (only-in "name.rkt" Greek-name?)
         racket/list)

(provide clear-tokens)

;; all      : tokens of a formula
;; known?   : symbol -> is it the name of something?
;; foreign? : symbol -> is it another program's name?
;; -> tokens for the grammar, or #f
(define (clear-tokens all known? foreign?)
  (define v (list->vector (with-fractions all edge)))
  (define (clear? i) (clear-at? (lambda (k) (token-near v (+ i k))) known? foreign?))
  (and (settle-parentheses! v)
       (for/and ([i (in-range (vector-length v))]) (clear? i))
       (one-relation? v)
       (vector->list v)))

(define edge (token 'end "" #f 0 #t))
(define (token-near v i) (if (< -1 i (vector-length v)) (vector-ref v i) edge))

(define (kind? t . kinds) (and (memq (token-kind t) kinds) #t))
(define (glued? t) (not (token-spaced? t)))
(define (sign? t text) (string=? (token-text t) text))

;; ---------------------------------------------------------------------------
;; Fractions

;; 1/2 as one number, so that a factor may follow: not in x^1/2, 1/2x, a/1/2.
(define (with-fractions all before)
  (define (glued-number? t) (and (kind? t 'number) (glued? t) (exact-integer? (token-value t))))
  (cond [(null? all) '()]
        [(and (kind? (car all) 'number) (exact-integer? (token-value (car all)))
              (not (kind? before 'caret 'slash))
              (pair? (cdr all)) (kind? (cadr all) 'slash) (glued? (cadr all))
              (glued-number? (caddr all))
              (not (eqv? 0 (token-value (caddr all))))
              (ends-number? (cadddr all)))
         (define next (caddr all))
         (define quotient (/ (token-value (car all)) (token-value next)))
         (cons (struct-copy token (car all) [value quotient])
               (with-fractions (cdddr all) next))]
        [else (cons (car all) (with-fractions (cdr all) (car all)))]))

(define (ends-number? t)
  (or (token-spaced? t) (kind? t 'plus 'minus 'times 'close 'end 'comma 'relation)))

;; ---------------------------------------------------------------------------
;; Parentheses

;; Parentheses of a call touch the name, those of a factor do not.  -> is it clear which they are?
(define (settle-parentheses! v)
  (for/and ([t (in-vector v)] [i (in-naturals)] #:when (kind? t 'open))
    (define spaced? (spaced-open v i))
    (when (boolean? spaced?) (vector-set! v i (struct-copy token t [spaced? spaced?])))
    (boolean? spaced?)))

;; -> boolean, or 'unclear
(define (spaced-open v i)
  (define before (token-near v (- i 1)))
  (define touching? (glued? (vector-ref v i)))
  (case (token-kind before)
    [(function) #f]
    [(number) (if (and touching? (kind? (token-near v (- i 2)) 'caret)) 'unclear #t)]
    [(raised) (cond [(kind? (token-near v (- i 2)) 'function) #f] [touching? 'unclear] [else #t])]
    [(close) (if (and touching? (of-call? v (enclosing v (- i 1)))) 'unclear #t)]
    [(name) (spaced-after-name v i (token-value before) touching?)]
    [else #t]))

(define (spaced-after-name v i name touching?)
  (cond [(or (pair? name) (eq? name 'pi)) #t]
        [(or (one-operand? v i) (several? v i)) #f]
        [(not touching?) (if (memq name '(f F)) 'unclear #t)]
        [(and (= i 1) (kind? (token-near v (+ 1 (closing v i))) 'end) (function-like? v i name)) #f]
        [else 'unclear]))

;; f(x + 1), not x(x - 1) or k(x - x0): a word, or a letter of functions
(define (function-like? v i name)
  (or (memq name '(f F V U L H))
      (not (one-letter? (letters-of (symbol->string name))))))

;; Do the parentheses hold one name, number or call?
(define (one-operand? v i)
  (define next (token-near v (+ i 1)))
  (define end (closing v i))
  (and (kind? next 'name 'function 'number)
       (or (= end (+ i 2))
           (and (kind? (token-near v (+ i 2)) 'open)
                (= end (+ 1 (closing v (+ i 2))))))))

;; Do they hold no argument, or several?
(define (several? v i)
  (define end (closing v i))
  (or (= end (+ i 1))
      (for/or ([k (in-range (+ i 1) end)])
        (and (kind? (vector-ref v k) 'comma) (= i (enclosing v k))))))

(define (of-call? v i)
  (and (kind? (token-near v (- i 1)) 'name 'function 'raised) (glued? (vector-ref v i))))

;; The place where the parenthesis at i is closed, the end if nowhere.
(define (closing v i)
  (let loop ([k (+ i 1)] [depth 0])
    (define t (token-near v k))
    (cond [(>= k (vector-length v)) k]
          [(kind? t 'open) (loop (+ k 1) (+ depth 1))]
          [(not (kind? t 'close)) (loop (+ k 1) depth)]
          [(= depth 0) k]
          [else (loop (+ k 1) (- depth 1))])))

;; The place of the parenthesis that holds the token at k, or is closed by it; -1 if none does
(define (enclosing v k)
  (let loop ([i (- k 1)] [depth 0])
    (define t (token-near v i))
    (cond [(< i 0) -1]
          [(kind? t 'close) (loop (- i 1) (+ depth 1))]
          [(not (kind? t 'open)) (loop (- i 1) depth)]
          [(= depth 0) i]
          [else (loop (- i 1) (- depth 1))])))

;; ---------------------------------------------------------------------------
;; Neighbors

;; near : number -> the token so many places behind
(define (clear-at? near known? foreign?)
  (define t (near 0))
  (case (token-kind t)
    [(number) (clear-number? t (near -1) (near 1))]
    [(name) (if (eq? (token-value t) 'D)
                (clear-derivative? near)
                (clear-name? t (near 1) known? foreign?))]
    [(function) (clear-function? near)]
    [(caret) (clear-power? near known?)]
    [(times) (or (not (sign? t "×")) (kind? (near -1) 'number) (kind? (near 1) 'number))]
    [(slash) (not (and (rate-sign? (near -1)) (rate-sign? (near 1))))]
    [(root) (clear-root? (near 1) (near 2))]
    [(minus) (clear-minus? (near -1) t (near 1))]
    [(plus) (not (and (kind? (near 1) 'minus) (glued? (near 1))))]
    [(relation) (not (member (token-text t) '("∘" "↦")))]
    [else #t]))

;; x 2, 2 1/2; 2i, 5e
(define (clear-number? t before next)
  (not (or (kind? before 'number 'close 'name 'raised)
           (and (kind? next 'name) (glued? next) (memq (token-value next) '(i j e E))))))

;; Powers: sin² x; a bare argument ends at a sign or the next function: not sin x y, sin x/2.
(define (clear-function? near)
  (define i
    (cond [(kind? (near 1) 'raised) (and (> (token-value (near 1)) 0) 2)]
          [(kind? (near 1) 'caret)
           (and (glued? (near 1)) (kind? (near 2) 'number) (exact-integer? (token-value (near 2)))
                3)]
          [else 1]))
  (and i
       (or (kind? (near i) 'open)
           (and (kind? (near i) 'name 'number)
                (kind? (near (+ i 1)) 'plus 'minus 'close 'end 'comma 'relation 'function)))))

;; x^2y, x^1/2, x^n y, e^-t/tau, e^2
(define (clear-power? near known?)
  (define i (if (kind? (near 1) 'minus) 2 1))
  (define exponent (near i))
  (define next (near (+ i 1)))
  (define e? (and (memq (token-value (near -1)) '(e E)) (not (known? (token-value (near -1))))))
  (case (token-kind exponent)
    [(number) (not (or (and (kind? next 'name 'function 'root) (glued? next))
                       (and (= 1 (token-value exponent)) (kind? next 'slash))
                       (and e? (sign? (near -1) "e"))))]
    [(name) (not (or (kind? next 'name 'function 'number 'open 'root)
                     (and e? (kind? next 'slash 'times))))]
    [else #t]))

;; √2x, √l/g
(define (clear-root? t next)
  (or (not (kind? t 'name 'number))
      (not (or (kind? next 'slash 'raised 'caret)
               (and (kind? next 'name 'function 'open 'number) (glued? next))))))

;; a-b, theta-phi; kinetic-energy and part-2 are names.
(define (clear-minus? before t next)
  (or (token-spaced? t) (token-spaced? next)
      (not (kind? before 'name)) (not (kind? next 'name 'number))
      (and (letter? before) (or (kind? next 'number) (letter? next)))))

(define (letter? t) (one-letter? (letters-of (token-text t))))
(define (one-letter? letters) (or (= 1 (string-length letters)) (Greek-name? letters)))

;; d of dx/dt
(define (rate-sign? t) (and (kind? t 'name) (regexp-match? #px"^d\\p{L}*$" (token-text t))))

;; One relation, in no parentheses, may stand several times.
(define (one-relation? v)
  (define relations
    (for/list ([t (in-vector v)] [i (in-naturals)] #:when (kind? t 'relation))
      (and (= -1 (enclosing v i)) (token-text t))))
  (or (null? relations)
      (and (car relations) (null? (cdr (remove-duplicates relations))))))

;; ---------------------------------------------------------------------------
;; Names

;; x'(t), which is D¹x(t) here; x' alone is a transposed matrix to some.
(define (clear-derivative? near)
  (not (and (kind? (near 1) 'raised) (kind? (near 2) 'name)
            (not (and (kind? (near 3) 'open) (glued? (near 3)))))))

(define (clear-name? t next known? foreign?)
  (define name (token-value t))
  (define text (token-text t))
  (cond [(member text keywords) #f]
        [(and (symbol? name) (foreign? name)) (not (kind? next 'open 'name 'number))]
        [(or (pair? name) (memq name '(pi D)) (known? name)) #t]
        [(regexp-match? #rx"^⟪" text) (not (and (kind? next 'open) (glued? next)))]
        [else (not (or (regexp-match? #px"_$|[0-9]\\p{L}" text) (letters-in-a-row? text)))]))

;; Words that are no names of quantities
(define keywords '("if" "else" "and" "or" "not" "lambda" "for" "in" "return" "def" "integral"
                   "times" "over" "plus" "minus" "half" "mod" "div" "squared"))

;; Is it rather a product or a call without its sign: mgh, omegat, sinx, pir, Dx?  A name has the
;; vowels of a word, or is a component or a difference, vx and dt.
(define (letters-in-a-row? text)
  (define letters (letters-of text))
  (define n (string-length letters))
  (cond [(or (one-letter? letters) (regexp-match? #px"^(?:[vF][xyz]|d[xyzrt]|kg)$" letters)) #f]
        [(regexp-match? #px"^(?:sin|cos|tan|exp|log|ln|sqrt|D)." text) (not (Greek-name? letters))]
        [(regexp-match? #px"^pi\\p{L}{1,2}$" letters) #t]
        [(Greek-beginning? letters) #t]
        [else (or (= n 2) (not (regexp-match? #px"^[a-zA-Z]*[aeiouAEIOU][a-zA-Z]*$" letters)))]))

(define (letters-of text)
  (define plain (regexp-replace* #px"\\p{M}" (string-normalize-nfd text) ""))
  (regexp-replace #rx"(.)(?:dot)+$" (car (regexp-match #px"^\\p{L}*" plain)) "\\1"))

;; theta and letters behind it; dots and digits may stand there.
(define (Greek-beginning? letters)
  (for/or ([n (in-range 3 (string-length letters))]) (Greek-name? (substring letters 0 n))))

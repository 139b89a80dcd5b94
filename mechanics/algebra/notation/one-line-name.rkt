#lang racket/base
;; Names on one line, and back: `theta_1` is θ₁, `xdotdot` is ẍ, `p_phi` is p_φ.
;;
;; A symbol that would be read as another stands between bars, as the variable pi, which is not
;; the number π.  So each text is read as the one symbol that it was written from.

(require "name.rkt"
         "../expression/operation.rkt" "../expression/pi.rkt")

(provide line-name dotted-line-name letters-of-name line-name->symbol known-word?
         superscript->text raised-text small-fraction->number quotient->small-fraction)

;; ---------------------------------------------------------------------------
;; Writing

;; A name that would be read as another one stands between bars: so does θ, as theta is θ.
(define (line-name s)
  (define p (name-parts s))
  (define text (if (eq? (parts-sort p) 'odd) "" (regular-text p)))
  (if (or (string=? text "") (reserved? text) (not (eq? s (line-name->symbol text))))
      (between-bars s)
      text))

(define (dotted-line-name s n) (regular-text (dotted-parts s n)))

;; The name under so many dots, for text that is not read back: without bars where only a Greek
;; letter, typed as such, asks for them.  #f of other names between bars.
(define (letters-of-name s dots)
  (define p (name-parts s))
  (define text (regular-text p))
  (define read (line-name->symbol text))
  (and (or (eq? s read)
           (and (not (eq? read exact-pi)) (equal? p (name-parts read))))
       (not (eq? (parts-sort p) 'odd))
       (not (reserved? text))
       (if (= dots 0) text (dotted-line-name s dots))))

(define (regular-text p)
  (string-append
   (string-normalize-nfc (string-append (parts-base p) (vector-ref dots (parts-dots p))))
   (parts-digits p)
   (apply string-append
          (for/list ([m (in-list (parts-marks p))])
            (if (eqv? (car m) #\_)
                (or (lowered-text (cdr m)) (string-append "_" (cdr m)))
                (string-append "^" (cdr m)))))))

(define dots (vector "" "\u307" "\u308" "\u20DB"))

;; Is the text read as a known function, or as the derivative of a name?
(define (reserved? text) (or (known-word? text) (regexp-match? #rx"^D." text)))

;; Is it the name of a function that is applied without parentheses, too, of a container or a
;; unit?
(define (known-word? text) (hash-has-key? known-words text))

(define known-words
  (for/hash ([s (in-list (append '(up down list 𝐢 𝐣 𝐤) written-names))])
    (values (symbol->string s) #t)))

(define (between-bars s)
  (string-append "|"
                 (regexp-replace* #px"[|\\\\]|\\p{C}|\\p{Z}" (symbol->string s) escaped)
                 "|"))

(define (escaped c)
  (cond [(member c '("|" "\\")) (string-append "\\" c)]
        [(string=? c " ") c]
        [else (format "\\u~a;" (number->string (char->integer (string-ref c 0)) 16))]))

;; ---------------------------------------------------------------------------
;; Reading

;; The symbol that a text without bars stands for.
(define (line-name->symbol text)
  (if (member text '("π" "pi")) ':pi (spelled-symbol text)))

(define (spelled-symbol text)
  (define m (regexp-match #px"^([^0-9₀-₉ₐ-ₜᵢᵣᵤᵥᵦ-ᵪ_^]+)([0-9]*)(.*)$" text))
  (define-values (base n) (dots-apart (if m (cadr m) text)))
  (string->symbol
   (string-append (letter-name base)
                  (apply string-append (for/list ([_ (in-range n)]) "dot"))
                  (if m (caddr m) "")
                  (if m (marks->text (cadddr m)) ""))))

(define (dots-apart text)
  (define decomposed (string-normalize-nfd text))
  (define last (and (> (string-length decomposed) 1)
                    (substring decomposed (sub1 (string-length decomposed)))))
  (define n (or (for/first ([d (in-vector dots)] [i (in-naturals)] #:when (equal? d last)) i) 0))
  (values (if (= n 0)
              text
              (string-normalize-nfc (substring decomposed 0 (sub1 (string-length decomposed)))))
          n))

(define (letter-name text) (or (letter->greek text) text))

(define (marks->text text)
  (apply string-append
         (for/list ([m (in-list (regexp-match* #px"[_^][^_^₀-₉ₐ-ₜᵢᵣᵤᵥᵦ-ᵪ]+|[₀-₉ₐ-ₜᵢᵣᵤᵥᵦ-ᵪ]+"
                                               text))])
           (if (memv (string-ref m 0) '(#\_ #\^))
               (string-append (substring m 0 1) (letter-name (substring m 1)))
               (string-append "_" (list->string (for/list ([c (in-string m)]) (raise c))))))))

;; ---------------------------------------------------------------------------
;; Letters below and above the line

(define lowered-letters
  (hasheqv #\0 #\₀ #\1 #\₁ #\2 #\₂ #\3 #\₃ #\4 #\₄ #\5 #\₅ #\6 #\₆ #\7 #\₇ #\8 #\₈ #\9 #\₉
           #\a #\ₐ #\e #\ₑ #\h #\ₕ #\i #\ᵢ #\j #\ⱼ #\k #\ₖ #\l #\ₗ #\m #\ₘ #\n #\ₙ #\o #\ₒ
           #\p #\ₚ #\r #\ᵣ #\s #\ₛ #\t #\ₜ #\u #\ᵤ #\v #\ᵥ #\x #\ₓ))

(define raised-letters (inverse lowered-letters))
(define (raise c) (hash-ref raised-letters c c))

;; The text below the line, or #f where a letter cannot stand there.
(define (lowered-text text)
  (define all (for/list ([c (in-string text)]) (hash-ref lowered-letters c #f)))
  (and (andmap values all) (list->string all)))

(define raised-digits
  (hasheqv #\0 #\⁰ #\1 #\¹ #\2 #\² #\3 #\³ #\4 #\⁴ #\5 #\⁵ #\6 #\⁶ #\7 #\⁷ #\8 #\⁸ #\9 #\⁹
           #\- #\⁻))

(define lower (inverse raised-digits))

;; Of digits and minus signs
(define (raised-text text)
  (list->string (for/list ([c (in-string text)]) (hash-ref raised-digits c))))
(define (superscript->text text)
  (list->string (for/list ([c (in-string text)]) (hash-ref lower c))))

;; Fractions that are one letter: ½ is 1/2.
(define small-fractions
  (hash "½" "1/2" "⅓" "1/3" "⅔" "2/3" "¼" "1/4" "¾" "3/4" "⅕" "1/5" "⅖" "2/5" "⅗" "3/5"
        "⅘" "4/5" "⅙" "1/6" "⅚" "5/6" "⅛" "1/8" "⅜" "3/8" "⅝" "5/8" "⅞" "7/8"))

(define quotients (inverse small-fractions))

(define (small-fraction->number text) (string->number (hash-ref small-fractions text)))
(define (quotient->small-fraction text) (hash-ref quotients text #f))
